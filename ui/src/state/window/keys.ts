/** Keys as data: what the menus write beside a command, what the list of keys shows, what a key press does. */

export type CommandId =
  | "new"
  | "open"
  | "add"
  | "open-stencil"
  | "examples"
  | "save"
  | "save-as"
  | "save-wireframe"
  | "save-job"
  | "quit"
  | "undo"
  | "redo"
  | "cut"
  | "copy"
  | "paste"
  | "duplicate"
  | "delete"
  | "select-all"
  | "select-connected"
  | "invert"
  | "straighten"
  | "round"
  | "fillet"
  | "rotate"
  | "mirror"
  | "array"
  | "scale"
  | "tool-select"
  | "tool-trace"
  | "tool-draw"
  | "tool-measure"
  | "move"
  | "extrude"
  | "split"
  | "merge"
  | "connect"
  | "construction"
  | "draw-construction"
  | "view-front"
  | "view-back"
  | "view-right"
  | "view-left"
  | "view-top"
  | "view-bottom"
  | "view-perspective"
  | "frame"
  | "frame-all"
  | "annotations"
  | "dimensions"
  | "construction-shown"
  | "units"
  | "play"
  | "stop"
  | "end"
  | "keys"
  | "about"
  | "hints";

export interface KeyEntry {
  readonly command: CommandId;
  readonly label: string;
  /** The first is the one that is written down. */
  readonly keys: readonly string[];
  readonly group: "File" | "Edit" | "Tools" | "View" | "Machine" | "Help";
  /** Whether it works while a person types: `always`, or where typing gives the key no meaning. */
  readonly typing?: "always" | "also";
  /**
   * It only looks, and its key is no part of a figure: it works although a field that was used last has lost the focus. What changes the
   * design, the selection or the tool does not, and neither does what takes the letters that follow.
   */
  readonly onlyLooks?: true;
  /** The browser's own event does it, which may use the clipboard. */
  readonly native?: boolean;
}

export const KEYS: readonly KeyEntry[] = [
  { command: "new", label: "New", keys: ["Ctrl+N"], group: "File", typing: "also" },
  { command: "open", label: "Open", keys: ["Ctrl+O"], group: "File", typing: "also" },
  { command: "save", label: "Save", keys: ["Ctrl+S"], group: "File", typing: "also" },
  { command: "save-as", label: "Save as", keys: ["Ctrl+Shift+S"], group: "File", typing: "also" },
  { command: "quit", label: "Quit", keys: ["Ctrl+Q"], group: "File" },
  { command: "undo", label: "Undo", keys: ["Ctrl+Z"], group: "Edit" },
  { command: "redo", label: "Redo", keys: ["Ctrl+Y", "Ctrl+Shift+Z"], group: "Edit" },
  { command: "cut", label: "Cut", keys: ["Ctrl+X"], group: "Edit", native: true },
  { command: "copy", label: "Copy", keys: ["Ctrl+C"], group: "Edit", native: true },
  { command: "paste", label: "Paste", keys: ["Ctrl+V"], group: "Edit", native: true },
  { command: "duplicate", label: "Duplicate", keys: ["Ctrl+D"], group: "Edit" },
  { command: "delete", label: "Delete", keys: ["X", "Delete"], group: "Edit" },
  { command: "select-all", label: "Select all", keys: ["A", "Ctrl+A"], group: "Edit" },
  { command: "select-connected", label: "Select connected", keys: ["L"], group: "Edit" },
  { command: "invert", label: "Invert selection", keys: ["Ctrl+I"], group: "Edit" },
  { command: "tool-select", label: "Select", keys: ["Q"], group: "Tools" },
  {
    command: "tool-trace",
    label: "Trace; while a strand is drawn digits set the length of its edge, after Tab its angle",
    keys: ["T"],
    group: "Tools",
  },
  { command: "tool-draw", label: "Draw on a plane", keys: ["D"], group: "Tools" },
  { command: "tool-measure", label: "Measure between any two things", keys: ["U"], group: "Tools" },
  {
    command: "move",
    label: "Move; then X, Y or Z locks an axis, digits set the distance",
    keys: ["G"],
    group: "Tools",
  },
  { command: "extrude", label: "Extrude an edge from each selected vertex", keys: ["E"], group: "Tools" },
  { command: "split", label: "Split the selected edges in the middle", keys: ["S"], group: "Tools" },
  { command: "merge", label: "Merge at the centre", keys: ["M"], group: "Tools" },
  { command: "connect", label: "Connect", keys: ["C"], group: "Tools" },
  {
    command: "construction",
    label: "Make construction lines of the selected edges, or edges of such lines",
    keys: ["K"],
    group: "Tools",
  },
  {
    command: "draw-construction",
    label: "Draw construction lines instead of edges, or edges again",
    keys: ["Shift+K"],
    group: "Tools",
  },
  { command: "fillet", label: "Fillet: round the selected corners by a radius", keys: ["B"], group: "Tools" },
  { command: "rotate", label: "Rotate the selection by an angle", keys: ["R"], group: "Tools" },
  { command: "end", label: "End a strand, give up a move, select nothing", keys: ["Escape"], group: "Tools" },
  { command: "view-front", label: "Front", keys: ["1"], group: "View" },
  { command: "view-back", label: "Back", keys: ["Ctrl+1"], group: "View" },
  { command: "view-right", label: "Right", keys: ["3"], group: "View" },
  { command: "view-left", label: "Left", keys: ["Ctrl+3"], group: "View" },
  { command: "view-top", label: "Top", keys: ["7"], group: "View" },
  { command: "view-bottom", label: "Bottom", keys: ["Ctrl+7"], group: "View" },
  { command: "view-perspective", label: "Perspective or parallel", keys: ["5"], group: "View" },
  { command: "frame", label: "Frame the selection", keys: ["F"], group: "View", onlyLooks: true },
  { command: "frame-all", label: "Frame all", keys: ["Home"], group: "View" },
  { command: "dimensions", label: "Dimensions of all edges and angles", keys: ["N"], group: "View", onlyLooks: true },
  { command: "play", label: "Play or pause; pause the wire that is bent", keys: ["Space"], group: "Machine" },
  { command: "stop", label: "STOP the machine", keys: ["Ctrl+Space"], group: "Machine", typing: "always" },
  { command: "keys", label: "Keys", keys: ["?"], group: "Help", onlyLooks: true },
];

const NAMES: Readonly<Record<string, string>> = { " ": "Space" };

/** A key press as the table writes it: "Ctrl+Shift+Z", "G", "?". */
export function chordOf(event: Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "shiftKey" | "altKey">): string {
  const name = NAMES[event.key] ?? (event.key.length === 1 ? event.key.toUpperCase() : event.key);
  // Shift makes another sign of most keys; where it makes a letter large, it is said.
  const shift = event.shiftKey && (event.key.length > 1 || name !== name.toLowerCase());
  return [event.ctrlKey || event.metaKey ? "Ctrl" : "", event.altKey ? "Alt" : "", shift ? "Shift" : "", name]
    .filter(Boolean)
    .join("+");
}

/** What a key press asks for; `typing` where the focus is in a field that takes text. */
export function commandOf(chord: string, typing: boolean): KeyEntry | null {
  const entry = KEYS.find(({ keys }) => keys.includes(chord));
  if (!entry || (typing && !entry.typing)) return null;
  return entry;
}

/** The key as it is written beside a command. */
export function keyOf(command: CommandId): string | undefined {
  const chord = KEYS.find((entry) => entry.command === command)?.keys[0];
  return chord?.replace("Escape", "Esc").replaceAll("+", "\u200a+\u200a");
}
