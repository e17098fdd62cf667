import { create } from "zustand";
import type { DisplayUnit } from "./units";

/** The sections of the panel, in the order of the work. */
const SECTIONS = [
  "parts",
  "trace",
  "edit",
  "check",
  "animate",
  "frame",
  "sequence",
  "machine",
  "export",
  "run",
] as const;
export type SectionId = (typeof SECTIONS)[number];

export type Theme = "system" | "dark" | "light";

/** Dialogs that a menu opens; each is shown by the part that it belongs to. */
export type DialogName = "examples" | "keys" | "about";

/** Operations with parameters, of which the section Edit shows one at a time. */
export type OperationName =
  | "split"
  | "merge"
  | "extrude"
  | "rotate"
  | "mirror"
  | "array"
  | "scale"
  | "straighten"
  | "round"
  | "fillet";

export interface Ui {
  readonly theme: Theme;
  /** What lengths are shown in; null where the person has not chosen: the design says it. */
  readonly unit: DisplayUnit | null;
  /** Which sections are open. */
  readonly open: readonly SectionId[];
  /** Of the panel, px. */
  readonly panelWidth: number;
  readonly dialog: DialogName | null;
  readonly operation: OperationName | null;
  /** Whether the list of machines in the bar at the top is open. */
  readonly choosingMachine: boolean;
  toggleSection(id: SectionId): void;
  /** Opens a section and brings it into sight. */
  showSection(id: SectionId): void;
  setTheme(theme: Theme): void;
  setUnit(unit: DisplayUnit): void;
  setPanelWidth(px: number): void;
  showDialog(dialog: DialogName | null): void;
  chooseMachine(open: boolean): void;
  /** Opens the parameters of an operation, or closes them. */
  showOperation(operation: OperationName | null): void;
}

export const PANEL = { least: 300, most: 720 } as const;

/** Of a panel that was not made wider, in a window that is so wide; px. */
export function usualPanel(windowWidth: number): number {
  return Math.min(440, Math.max(344, Math.round(windowWidth * 0.19)));
}

const KEY = "wirebend.ui";

interface Kept {
  theme: Theme;
  unit: DisplayUnit | null;
  open: SectionId[];
  panelWidth: number;
}

/** What was kept, as far as it makes sense. */
export function keptUi(text: string | null, windowWidth: number): Kept {
  let read: Partial<Record<keyof Kept, unknown>> = {};
  try {
    const parsed: unknown = JSON.parse(text ?? "{}");
    if (typeof parsed === "object" && parsed !== null) read = parsed;
  } catch {
    // What cannot be read is as if it were not there: nothing depends on it.
  }
  const theme = read.theme === "dark" || read.theme === "light" ? read.theme : "system";
  const unit = read.unit === "mm" || read.unit === "inch" ? read.unit : null;
  const open = Array.isArray(read.open)
    ? SECTIONS.filter((id) => (read.open as unknown[]).includes(id))
    : (["check"] as SectionId[]);
  const width =
    typeof read.panelWidth === "number" && Number.isFinite(read.panelWidth) ? read.panelWidth : usualPanel(windowWidth);
  return { theme, unit, open, panelWidth: Math.min(PANEL.most, Math.max(PANEL.least, width)) };
}

export function stored(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

export function store(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // A window that may not keep anything works anyway.
  }
}

export const useUi = create<Ui>()((set, get) => ({
  ...keptUi(stored(KEY), globalThis.innerWidth ?? 1280),
  dialog: null,
  operation: null,
  choosingMachine: false,
  toggleSection: (id) =>
    set(({ open }) => ({ open: open.includes(id) ? open.filter((other) => other !== id) : [...open, id] })),
  showSection: (id) => {
    if (!get().open.includes(id)) get().toggleSection(id);
    requestAnimationFrame(() => document.getElementById(`section-${id}`)?.scrollIntoView({ block: "nearest" }));
  },
  setTheme: (theme) => set({ theme }),
  setUnit: (unit) => set({ unit }),
  setPanelWidth: (px) => set({ panelWidth: Math.min(PANEL.most, Math.max(PANEL.least, Math.round(px))) }),
  showDialog: (dialog) => set({ dialog }),
  chooseMachine: (choosingMachine) => set({ choosingMachine }),
  showOperation: (operation) => {
    set({ operation });
    if (operation === null) return;
    get().showSection("edit");
    requestAnimationFrame(() =>
      document.getElementById(`operation-${operation}`)?.scrollIntoView({ block: "nearest" }),
    );
  },
}));

/** Keeps what is there again the next time. */
export function keepUi({ theme, unit, open, panelWidth }: Ui): void {
  store(KEY, JSON.stringify({ theme, unit, open, panelWidth }));
}
