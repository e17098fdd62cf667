/** Which move a key asks for while the machine is moved by keys. Pure. */

export type Axis = "feed" | "bend" | "rotate";

/** mm and degrees. */
export type Steps = Readonly<Record<Axis, number>>;

export type StepName = "fine" | "medium" | "coarse";

/** What a press moves by: from the width of a mark to a usual edge and its corner. */
export const STEPS: Readonly<Record<StepName, Steps>> = {
  fine: { feed: 0.1, bend: 0.5, rotate: 0.5 },
  medium: { feed: 1, bend: 5, rotate: 5 },
  coarse: { feed: 10, bend: 45, rotate: 90 },
};

const NAMES = ["fine", "medium", "coarse"] as const;

const KEYS: Readonly<Partial<Record<string, readonly [Axis, 1 | -1]>>> = {
  ArrowRight: ["feed", 1],
  ArrowLeft: ["feed", -1],
  ArrowUp: ["bend", 1],
  ArrowDown: ["bend", -1],
  PageUp: ["rotate", 1],
  PageDown: ["rotate", -1],
};

export type Pressed =
  | { readonly kind: "move"; readonly axis: Axis; readonly by: number }
  | { readonly kind: "step"; readonly name: StepName }
  | { readonly kind: "end" }
  /** It is one of these keys, and does nothing now. */
  | { readonly kind: "nothing" };

/** What a press asks for; null of a key that has no meaning here. A key that is held down moves once: the machine stops where a person looks. */
export function pressedKey(
  { key, repeat, ctrlKey, altKey, metaKey }: Pick<KeyboardEvent, "key" | "repeat" | "ctrlKey" | "altKey" | "metaKey">,
  steps: Steps,
  step: StepName | null,
): Pressed | null {
  if (ctrlKey || altKey || metaKey) return null;
  if (key === "Escape") return { kind: "end" };
  const move = KEYS[key];
  if (move) {
    const [axis, way] = move;
    return repeat ? { kind: "nothing" } : { kind: "move", axis, by: way * steps[axis] };
  }
  const turn = key === "+" || key === "=" ? 1 : key === "-" || key === "_" ? -1 : 0;
  if (turn === 0) return null;
  const at = step === null ? 1 : NAMES.indexOf(step) + turn;
  return { kind: "step", name: NAMES[Math.min(Math.max(at, 0), NAMES.length - 1)] ?? "medium" };
}

/** The name of these steps; null where a person has typed others. */
export const nameOf = (steps: Steps): StepName | null =>
  NAMES.find((name) => (["feed", "bend", "rotate"] as const).every((axis) => STEPS[name][axis] === steps[axis])) ??
  null;
