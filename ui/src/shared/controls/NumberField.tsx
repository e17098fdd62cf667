import {
  type FocusEvent,
  type KeyboardEvent,
  type MouseEvent,
  useEffect,
  useLayoutEffect,
  useRef,
  useState,
} from "react";
import "./controls.css";
import { type DisplayUnit, lengthNumber, number, short, unitName, unitSize } from "../figures/format";
import { parseAngle, parseLength, parseNumber } from "../figures/parse";
import { useUnit } from "../figures/unit";

type Quantity = "length" | "fine" | "angle" | "number" | "percent" | "whole";

interface Kind {
  readonly unit: string;
  /** What is read, said to a person whose text is not. */
  readonly expected: string;
  show(value: number): string;
  /** The same within a sentence: with its unit, and no more digits than it needs. */
  say(value: number): string;
  read(text: string): number | null;
  /** What an arrow key adds. */
  readonly step: number;
}

const lengthExpected = (unit: DisplayUnit): string =>
  unit === "inch"
    ? "a length such as 1/2, 12 mm, or a sum such as 2+1/4"
    : "a length such as 12.5, 1/2 in, or a sum such as 12+3.5";

/** A number of anything, such as a mass, with its own unit or none. */
const plainNumber = (unit: string): Kind => ({
  unit,
  expected: "a number, or a sum such as 12+3.5",
  show: (value) => short(value).replace(/\u202f/g, ""),
  say: (value) => short(value) + (unit && ` ${unit}`),
  read: (text) => parseNumber(unit && text.trimEnd().endsWith(unit) ? text.trimEnd().slice(0, -unit.length) : text),
  step: 0.1,
});

/** A length of a machine, which has as many digits as were measured; `per`: "/s" of a speed. */
const fineLength = (unit: DisplayUnit, per: string): Kind => {
  const mm = unitSize(unit);
  return {
    unit: unitName(unit) + per,
    expected: lengthExpected(unit),
    show: (value) => short(value / mm).replace(/\u202f/g, ""),
    say: (value) => `${short(value / mm)} ${unitName(unit)}${per}`,
    read: (text) =>
      parseLength(per && text.trimEnd().endsWith(per) ? text.trimEnd().slice(0, -per.length) : text, unit),
    step: 0.1 * (unit === "inch" ? 2.54 : 1),
  };
};

/** How a quantity is shown and read. Lengths in mm, angles in degrees, percent as a share of 1; `own`: see `unit`. */
function quantity(kind: Quantity, unit: DisplayUnit, own: string): Kind {
  const plain = (text: string) => text.replace(/\u202f/g, "");
  switch (kind) {
    case "length":
      return {
        unit: unitName(unit),
        expected: lengthExpected(unit),
        show: (mm) => plain(lengthNumber(mm, unit)),
        say: (mm) => `${short(mm / unitSize(unit))} ${unitName(unit)}`,
        read: (text) => parseLength(text, unit),
        step: unit === "inch" ? 2.54 : 1,
      };
    case "fine":
      return fineLength(unit, own);
    case "angle":
      return {
        unit: "°",
        expected: "an angle such as 45, or a sum such as 90-7.5",
        show: (deg) => plain(number(deg)),
        say: (deg) => `${short(deg)}°`,
        read: parseAngle,
        step: 1,
      };
    case "percent":
      return {
        unit: "%",
        expected: "a number of percent, such as 50",
        show: (share) => plain(number(share * 100, Number.isInteger(Math.round(share * 1e6) / 1e4) ? 0 : 1)),
        say: (share) => `${short(share * 100)} %`,
        read: (text) => {
          const value = parseNumber(text.replace(/%\s*$/, ""));
          return value === null ? null : value / 100;
        },
        step: 0.01,
      };
    case "whole":
      return {
        unit: "",
        expected: "a whole number",
        show: (value) => plain(number(value, 0)),
        say: (value) => number(value, 0),
        read: (text) => {
          const value = parseNumber(text);
          return value !== null && Number.isInteger(value) ? value : null;
        },
        step: 1,
      };
    case "number":
      return plainNumber(own);
  }
}

/** "from 3 to 10 000", "more than 0 mm, at most 100 mm". `positive`: the least is only there to keep out nothing. */
function limitsText({ say }: Kind, min: number, max: number, positive: boolean): string {
  const most = Number.isFinite(max) ? say(max) : null;
  if (positive) return `more than ${say(0)}${most === null ? "" : `, at most ${most}`}`;
  if (most === null) return `at least ${say(min)}`;
  return Number.isFinite(min) ? `from ${say(min)} to ${most}` : `at most ${most}`;
}

const isInMenu = (target: EventTarget | null): boolean =>
  target instanceof Element && target.closest("[role=menu]") !== null;

export interface NumberFieldProps {
  /** Read aloud; the visible label may be a letter in the field. */
  readonly label: string;
  /** A letter or word in front, such as "X". */
  readonly prefix?: string;
  readonly kind?: Quantity;
  /** Of a `number` that has one, such as "g"; of a `fine` length what it is per, such as "/s"; the other kinds have their own. */
  readonly unit?: string;
  /** null: nothing in common, or not known; the field is empty. */
  readonly value: number | null;
  /** Called with Enter, by leaving the field, and by the arrow keys; not while a person types. */
  readonly onCommit: (value: number) => void;
  /**
   * Called while a person types: with what is read, and with null where it is none, or is taken or given up. `isTyping` says which of
   * these: what is half written may become a number with the next key.
   */
  readonly onType?: (value: number | null, isTyping: boolean) => void;
  readonly min?: number;
  readonly max?: number;
  /** It has to be more than 0: `min` is as little as is worth a number. */
  readonly positive?: boolean;
  readonly placeholder?: string;
  readonly why?: string | null | undefined;
  readonly id?: string;
  readonly "aria-describedby"?: string | undefined;
  /** Enter is pressed, after `onCommit`: with what was read just now, which `value` is only later. Not where the field is empty or wrong. */
  readonly onEnter?: (value: number) => void;
}

/** A number with its unit. Reads "12.5", "12,5", "1/2 in", "12 mm"; Esc takes back what was typed; arrows step, by ten with Shift. */
export function NumberField({
  label,
  prefix,
  kind = "length",
  unit = "",
  value,
  onCommit,
  onType,
  min = -Infinity,
  max = Infinity,
  positive = false,
  placeholder,
  why,
  id,
  onEnter,
  ...rest
}: NumberFieldProps) {
  const how = quantity(kind, useUnit(), unit);
  const shown = value === null ? "" : how.show(value);
  const [typed, keepTyped] = useState<string | null>(null);
  /** Enter was pressed on it as it stands. */
  const [entered, setEntered] = useState(false);
  const inRange = (number: number | null) => (number !== null && number >= min && number <= max ? number : null);
  /** What was left in the field though it could not be taken, and what is expected instead. */
  const [refused, setRefused] = useState<string | null>(null);
  const setTyped = (text: string | null) => {
    keepTyped(text);
    setRefused(null);
    setEntered(false);
    onType?.(text === null ? null : inRange(how.read(text)), text !== null);
  };
  /** A menu has taken the focus from it. */
  const [inMenu, setInMenu] = useState(false);
  const field = useRef<HTMLInputElement>(null);
  // What the arrow keys asked for and `value` is not yet: the next press continues from the last of them.
  const stepped = useRef<number[]>([]);
  // Before the next key comes: later, what that has typed would be taken away.
  // biome-ignore lint/correctness/useExhaustiveDependencies: another value takes the place of what was typed
  useLayoutEffect(() => {
    setTyped(null);
    // A value that a form proposes while the field has the focus is replaced by what is typed, as the one before it.
    if (stepped.current.length === 0 && document.activeElement === field.current) field.current?.select();
  }, [shown]);
  useEffect(() => {
    const reached = stepped.current.findIndex((asked) => value !== null && Math.abs(asked - value) < 1e-9);
    stepped.current = reached < 0 ? [] : stepped.current.slice(reached + 1);
  }, [value]);

  const read = typed === null ? value : how.read(typed);
  const outside = read !== null && inRange(read) === null;
  const wrong = typed !== null && typed.trim() !== "" && (read === null || outside);
  const limits = outside ? limitsText(how, min, max, positive && read <= 0) : how.expected;
  // What ends so is not written to its end: it is no time to correct it, unless Enter says that it is.
  const halfWritten = typed !== null && !entered && /[-\u2212+.,/]\s*$/.test(typed);

  /** What stands there now; null where it is empty or wrong. */
  const commit = (): number | null => {
    const latest = stepped.current.at(-1) ?? value;
    if (typed === null || typed === shown) {
      setTyped(null);
      return latest;
    }
    if (read === null || outside) {
      if (typed.trim() === "") setTyped(null);
      return null;
    }
    stepped.current = [];
    onCommit(read);
    setTyped(null);
    return read;
  };
  const keys = (event: KeyboardEvent) => {
    if (event.key === "Enter") {
      const taken = commit();
      setEntered(taken === null);
      // A key that is held down asks once.
      if (taken !== null && !event.repeat) onEnter?.(taken);
    } else if (event.key === "Escape" && typed !== null) {
      // It would close the dialog that the field is in.
      event.preventDefault();
      event.stopPropagation();
      setTyped(null);
    } else if ((event.key === "ArrowUp" || event.key === "ArrowDown") && read !== null) {
      event.preventDefault();
      const step = how.step * (event.shiftKey ? 10 : 1) * (event.key === "ArrowUp" ? 1 : -1);
      const from = typed === null ? (stepped.current.at(-1) ?? read) : read;
      const next = Math.min(max, Math.max(min, from + step));
      stepped.current.push(next);
      setTyped(null);
      onCommit(next);
    }
  };
  const left = () => {
    if (wrong) {
      setTyped(null);
      // The value of before is back: without a word it would be taken for the one that was typed.
      setRefused(`“${typed.trim()}” was not taken: expected ${limits}`);
    } else commit();
    stepped.current = [];
  };
  const leave = ({ relatedTarget }: FocusEvent) => {
    // Another window has the focus: coming back would clear what is said of a value before it is read. It is still there to be corrected.
    if (wrong && !document.hasFocus()) return;
    if (isInMenu(relatedTarget)) setInMenu(true);
    else left();
  };
  // The menu of a right click gives the focus back; where something else has got it, the field is left.
  useEffect(() => {
    if (!inMenu) return;
    const look = ({ target }: Event) => {
      if (isInMenu(target)) return;
      setInMenu(false);
      if (target !== field.current) left();
    };
    document.addEventListener("focusin", look);
    return () => document.removeEventListener("focusin", look);
  });
  // It was read by whoever goes on elsewhere with the pointer; with keys it stays until they come back.
  useEffect(() => {
    if (refused === null) return;
    const over = () => setRefused(null);
    document.addEventListener("pointerdown", over);
    return () => document.removeEventListener("pointerdown", over);
  }, [refused]);
  /** A click beside the digits, such as on the unit, is one on the field. */
  const beside = (event: MouseEvent) => {
    if (event.target === field.current) return;
    event.preventDefault();
    if (document.activeElement !== field.current) field.current?.focus();
  };
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the field in it is what is used; around it is its frame
    <span
      className={wrong ? "number-field wrong" : "number-field"}
      onMouseDown={beside}
      data-off={why ? true : undefined}
      title={why ?? (wrong ? `Expected ${limits}` : undefined)}
    >
      {prefix && (
        <span className="number-prefix" aria-hidden="true">
          {prefix}
        </span>
      )}
      <input
        {...rest}
        id={id}
        ref={field}
        type="text"
        // With nothing typed that is not taken, undo is for what was changed by it.
        data-undo={typed === null ? "design" : undefined}
        inputMode="decimal"
        autoComplete="off"
        spellCheck={false}
        aria-label={id === undefined ? (how.unit ? `${label}, ${how.unit}` : label) : undefined}
        aria-invalid={wrong || undefined}
        readOnly={Boolean(why)}
        aria-disabled={why ? true : undefined}
        value={typed ?? shown}
        placeholder={placeholder}
        onFocus={(event) => {
          setRefused(null);
          event.currentTarget.select();
        }}
        onChange={(event) => !why && setTyped(event.currentTarget.value)}
        onBlur={leave}
        onKeyDown={keys}
      />
      {how.unit && (
        <span className="number-unit" aria-hidden="true">
          {how.unit}
        </span>
      )}
      {wrong && !halfWritten && (
        <span className="number-expected" role="alert">
          Expected {limits}
        </span>
      )}
      {refused !== null && (
        <span className="number-expected left" role="alert">
          {refused}
        </span>
      )}
    </span>
  );
}
