import { create } from "zustand";
import type { ExportPreview, FormatEntry } from "../../generated/responses";
import { Refused } from "../../platform";
import { errorText } from "../../platform/error_text";
import { asking } from "../asking/work";
import { ofDesign } from "../design/design";
import { type DisplayUnit, useUnits } from "../window/units";

/** Settings of a format, by key. */
export type Settings = Readonly<Record<string, unknown>>;

interface ExportsStore {
  /** Null before they are known. */
  readonly formats: readonly FormatEntry[] | null;
  /** Drivers that could not be asked, and why. */
  readonly problems: readonly string[];
  /** Why there are no formats. */
  readonly problem: string | null;
  /** Id of the chosen format; null: the first. */
  readonly chosen: string | null;
  /** What a person has set, by format; formats that are not named have what the profile says. */
  readonly settings: ReadonlyMap<string, Settings>;
  readonly despiteErrors: boolean;
  readonly preview: Preview | null;
  readonly previewing: boolean;
  /** What was written last, by format, and what was not looked at for it. */
  readonly written: {
    readonly format: string;
    readonly files: readonly string[];
    readonly notSearched: string | null;
  } | null;
}

interface Preview {
  readonly format: string;
  readonly seen: ExportPreview | null;
  /** Why there is nothing to see; `errors`: because the machine cannot make it. */
  readonly refused: { readonly message: string; readonly errors: boolean } | null;
}

export const useExports = create<ExportsStore>()(() => ({
  formats: null,
  problems: [],
  problem: null,
  chosen: null,
  settings: new Map(),
  despiteErrors: false,
  preview: null,
  previewing: false,
  written: null,
}));

let formatsAsked = 0;

/** Asks what can be written for the machine. Of several questions only the last one's answer counts. */
export async function loadFormats(): Promise<void> {
  formatsAsked += 1;
  const question = formatsAsked;
  let answer: Partial<ExportsStore>;
  try {
    const { formats, problems } = await asking("exports", {});
    answer = { formats, problems: problems.map(errorText), problem: null };
  } catch (error) {
    answer = { formats: null, problem: error instanceof Error ? error.message : String(error) };
  }
  if (question !== formatsAsked) return;
  const { chosen } = useExports.getState();
  const gone = answer.formats && !answer.formats.some(({ id }) => id === chosen);
  useExports.setState(gone ? { ...answer, chosen: null } : answer);
}

/** The chosen format, else the machine's own. */
export function chosenFormat({ formats, chosen }: Pick<ExportsStore, "formats" | "chosen">): FormatEntry | null {
  return formats?.find(({ id }) => id === chosen) ?? formats?.[0] ?? null;
}

/** What lengths are written in where nothing else is set: of what a person reads it is what the window shows. */
function shownUnits(format: FormatEntry, unit: DisplayUnit): Settings {
  const properties = (format.settings_schema as { readonly properties?: object } | null)?.properties;
  // A driver's unit is that of its machine or of another program.
  const reads = format.driver === null && properties !== undefined && "units" in properties;
  return reads ? { units: unit === "inch" ? "in" : "mm" } : {};
}

/** The settings that are written with: those of the person, else those of the profile. `unit`: what the window shows. */
export function settingsOf(
  format: FormatEntry,
  settings: ReadonlyMap<string, Settings>,
  unit: DisplayUnit = useUnits.getState().unit,
): Settings {
  return { ...shownUnits(format, unit), ...(settings.get(format.id) ?? format.settings) };
}

/** What a person has set, without the unit where it is that of the window: it goes on following the window. */
export function asSet(format: FormatEntry, settings: Settings, unit: DisplayUnit): Settings {
  const shown = shownUnits(format, unit);
  return Object.fromEntries(Object.entries(settings).filter(([key, value]) => shown[key] !== value));
}

export function chooseFormat(format: string): void {
  useExports.setState((store) =>
    chosenFormat(store)?.id === format ? { chosen: format } : { chosen: format, preview: null, written: null },
  );
}

export function setSettings(format: string, settings: Settings): void {
  useExports.setState((store) => ({ settings: new Map(store.settings).set(format, settings) }));
}

export function setDespiteErrors(despiteErrors: boolean): void {
  useExports.setState({ despiteErrors });
}

let asked = 0;

/** Asks for the first lines of what would be written. Of several questions only the last one's answer counts. */
export async function preview(): Promise<void> {
  const store = useExports.getState();
  const format = chosenFormat(store);
  if (!format) return;
  asked += 1;
  const question = asked;
  useExports.setState({ previewing: true });
  let answer: Preview;
  try {
    const settings = { ...settingsOf(format, store.settings) };
    const seen = await asking("export", { format: format.id, settings, despite_errors: store.despiteErrors });
    answer = { format: format.id, seen, refused: null };
  } catch (error) {
    answer = { format: format.id, seen: null, refused: refusal(error) };
  }
  if (question === asked) useExports.setState({ preview: answer, previewing: false });
}

/** All of the file that would be written now, as it would be. */
export async function fileBytes(format: FormatEntry): Promise<Uint8Array> {
  const { settings, despiteErrors } = useExports.getState();
  const { contents } = await asking("export", {
    format: format.id,
    settings: { ...settingsOf(format, settings) },
    despite_errors: despiteErrors,
    contents: true,
  });
  return Uint8Array.from(atob(contents[0] ?? ""), (letter) => letter.charCodeAt(0));
}

function refusal(error: unknown): { message: string; errors: boolean } {
  const message = error instanceof Error ? error.message : String(error);
  return { message, errors: error instanceof Refused && error.refusal.code === "not-feasible" };
}

/** Writes the file. The person has been asked whether one that is there may be replaced. */
export async function write(format: FormatEntry, path: string, force: boolean): Promise<void> {
  const store = useExports.getState();
  const settings = { ...settingsOf(format, store.settings) };
  const output = { path, force };
  const before = forgotten;
  const asked = asking("export", { format: format.id, settings, despite_errors: store.despiteErrors, output });
  const { files, notes } = await ofDesign(asked);
  // What the preview says too is not said again.
  const note = notes.find(({ code }) => code === "collisions-not-searched");
  const written = { format: format.id, files, notSearched: note ? errorText(note) : null };
  if (before === forgotten) useExports.setState({ written });
}

let forgotten = 0;

/** What a person has said, and what was answered, was about another design or another machine. */
export function forgetExports(): void {
  forgotten += 1;
  asked += 1;
  useExports.setState({ settings: new Map(), despiteErrors: false, preview: null, previewing: false, written: null });
}
