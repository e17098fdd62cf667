import { create } from "zustand";
import type { Requests } from "../../generated/requests";
import type { HeadReport, ProfileView, ValueReport } from "../../generated/responses";
import { platform, Refused } from "../../platform";
import { useDesign } from "../design/design";
import { profilesChanged } from "./machines";

/** What can be edited. */
export type ProfileKind = "machine" | "material";
/** Only a machine has bodies. */
export type ProfilePart = "values" | "bodies";
/** A value without its source; the generated types know JSON as objects alone. */
export type PlainValue = number | string | boolean | object | null;
type JsonValue = Requests["set-profile"]["values"][number]["value"];

/** Where the values come from that a person enters. */
export interface EnteredSource {
  readonly text: string;
  readonly measured: boolean;
}

interface ProfileStore {
  /** The profile whose editor is open. */
  readonly open: { readonly kind: ProfileKind; readonly id: string } | null;
  /** Which part of it is shown. */
  readonly part: ProfilePart;
  /** The body that is chosen first, by its name. */
  readonly body: string | null;
  /** Null before it is known. */
  readonly view: ProfileView | null;
  /** Why it cannot be shown. */
  readonly problem: string | null;
  /** The value that was refused last, and why. */
  readonly refused: { readonly key: string; readonly message: string } | null;
  readonly busy: boolean;
  readonly source: EnteredSource;
  /** The bend head with a dimension that is typed and not written yet; null where none is. */
  readonly typedHead: HeadReport | null;
}

/** "measured by me on 2026-11-26". */
export const measuredToday = (now = new Date()): string =>
  `measured by me on ${now.getFullYear()}-${String(now.getMonth() + 1).padStart(2, "0")}-${String(now.getDate()).padStart(2, "0")}`;

export const useProfile = create<ProfileStore>()(() => ({
  open: null,
  part: "values",
  body: null,
  view: null,
  problem: null,
  refused: null,
  busy: false,
  source: { text: measuredToday(), measured: true },
  typedHead: null,
}));

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** The wire that the head of a machine is drawn with: that of the design where it is its machine. */
function wireOf(kind: ProfileKind, id: string): { material?: string } {
  const { state } = useDesign.getState();
  return kind === "machine" && state?.machine === id && state.material ? { material: state.material } : {};
}

/** Opens the editor of a profile. */
export async function openProfile(
  kind: ProfileKind,
  id: string,
  part: ProfilePart = "values",
  body: string | null = null,
): Promise<void> {
  const source = { text: measuredToday(), measured: true };
  useProfile.setState({
    open: { kind, id },
    part,
    body,
    view: null,
    problem: null,
    refused: null,
    busy: false,
    source,
    typedHead: null,
  });
  try {
    const view = await platform.ask("profile-view", { kind, id, ...wireOf(kind, id) });
    if (useProfile.getState().open?.id === id) useProfile.setState({ view });
  } catch (error) {
    if (useProfile.getState().open?.id === id) useProfile.setState({ problem: messageOf(error) });
  }
}

/** Opens the bodies of the design's machine, where their dimensions are entered, and chooses one of them by its name. */
export function openBodies(body: string | null): void {
  const machine = useDesign.getState().state?.machine;
  if (machine) void openProfile("machine", machine, "bodies", body);
}

export function showPart(part: ProfilePart): void {
  useProfile.setState({ part, body: null });
}

export function closeProfile(): void {
  useProfile.setState({ open: null, view: null, problem: null, refused: null, typedHead: null });
}

export function enterSource(source: EnteredSource): void {
  useProfile.setState({ source });
}

export const reportOf = (view: ProfileView | null, key: string): ValueReport | null =>
  view?.profile.values.find((value) => value.key === key) ?? null;

/** Whether a profile of the person's own has a value, or something of it, otherwise than its parent: it can be taken back. */
export const isOwn = (view: ProfileView | null, key: string): boolean =>
  view !== null &&
  !view.shipped &&
  view.profile.chain.length > 1 &&
  view.profile.values.some(
    (value) => value.set_by === view.profile.id && (value.key === key || value.key.startsWith(`${key}.`)),
  );

// One after the other: each is written on what the one before has left.
let last: Promise<unknown> = Promise.resolve();
/** How many changes are asked for and not answered. */
let openChanges = 0;

function changed(key: string, ask: (kind: ProfileKind, id: string) => Promise<ProfileView>): Promise<boolean> {
  const { open } = useProfile.getState();
  if (!open) return Promise.resolve(false);
  openChanges += 1;
  const change = last.then(async () => {
    useProfile.setState({ busy: true, refused: null });
    try {
      const view = await ask(open.kind, open.id);
      if (useProfile.getState().open?.id === open.id) useProfile.setState({ view });
      profilesChanged(null);
      return true;
    } catch (error) {
      useProfile.setState({ refused: { key, message: messageOf(error) } });
      return false;
    } finally {
      openChanges -= 1;
      useProfile.setState({ busy: false });
      showTyped(null);
    }
  });
  last = change;
  return change;
}

/** Sets a value of the open profile, with the source that was entered or another one. */
export function setValue(key: string, value: PlainValue, source = useProfile.getState().source): Promise<boolean> {
  return changed(key, (kind, id) =>
    platform.ask("set-profile", {
      kind,
      id,
      values: [{ key, value: value as JsonValue }],
      source: source.text,
      measured: source.measured,
      ...wireOf(kind, id),
    }),
  );
}

/** The dimensions that the drawing of the head has. */
const OF_HEAD: readonly string[] = [
  "bend.pin_radius_mm",
  "bend.rod_radius_mm",
  "bend.orbit_radius_mm",
  "bend.orbit_offset_mm",
];

/** Counts what is typed: an answer to what was typed before is too late. */
let typedTimes = 0;

function showTyped(typedHead: HeadReport | null): void {
  typedTimes += 1;
  if (useProfile.getState().typedHead !== typedHead) useProfile.setState({ typedHead });
}

/**
 * Draws the head with a dimension while it is typed; null ends that. What cannot be leaves the drawing as it was, and what is being
 * written is drawn until it is.
 */
export async function typeDimension(key: string, value: number | null): Promise<void> {
  const { open } = useProfile.getState();
  if (open?.kind !== "machine" || !OF_HEAD.includes(key)) return;
  if (value === null) {
    if (openChanges === 0) showTyped(null);
    return;
  }
  typedTimes += 1;
  const mine = typedTimes;
  try {
    const values = [{ key, value: value as unknown as JsonValue }];
    const head = await platform.ask("draw-head", { id: open.id, values, ...wireOf("machine", open.id) });
    if (mine === typedTimes) showTyped(head);
  } catch {
    // It is said when the value is to be taken.
  }
}

/** Makes values as they are in the parent again. */
export function takeBack(key: string, keys: readonly string[] = [key]): Promise<boolean> {
  return changed(key, (kind, id) => platform.ask("revert-profile", { kind, id, keys: [...keys], ...wireOf(kind, id) }));
}

/** The key of a machine's bodies. */
export const SHAPES = "shapes";

/** What a refusal of the last change is shown under. */
export const LAST_CHANGE = "";

/** Takes back the last change of the file, or makes it again. */
export function takeBackLast(): Promise<boolean> {
  return changed(LAST_CHANGE, (kind, id) =>
    platform.ask("revert-profile", { kind, id, keys: [], ...wireOf(kind, id) }),
  );
}

/** A profile that was taken in. */
export interface Imported {
  readonly name: string;
  /** Its name in the file, where another profile here is called so. */
  readonly ownName: string | null;
  /** Whether it was there already. */
  readonly known: boolean;
  readonly others: readonly string[];
}

/** What to say of it. */
export function importedPhrase({ name, ownName, known, others }: Imported): string {
  if (known) return `The profile is here already: it is that of “${name}”.`;
  const why = ownName === null ? "" : ` Another one is called “${ownName}”.`;
  return `“${name}” is one of your profiles now${others.length > 0 ? `, with ${others.join(" and ")}` : ""}.${why}`;
}

/** Takes a profile in from a file. Gives why not, with whether another id would help. */
export async function importProfile(
  file: string,
  id: string | null,
): Promise<Imported | { readonly problem: string; readonly taken: boolean }> {
  try {
    const taken = await platform.ask("import-profile", { file, ...(id === null ? {} : { id }) });
    profilesChanged(null);
    const { name, own_name: ownName, known } = taken;
    return { name, ownName, known, others: taken.with.map((other) => other.id) };
  } catch (error) {
    const taken = error instanceof Refused && error.refusal.code === "id-taken";
    return { problem: messageOf(error), taken };
  }
}
