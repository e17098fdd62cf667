import { run, useWhyNot } from "../../state/window/commands";
import { type CommandId, keyOf } from "../../state/window/keys";
import { useView } from "../../state/window/view";
import "./viewport.css";

/** Each side before the one across from it, which has the same key with Ctrl. */
const SIDES: readonly (readonly [CommandId, string])[] = [
  ["view-front", "Front"],
  ["view-back", "Back"],
  ["view-right", "Right"],
  ["view-left", "Left"],
  ["view-top", "Top"],
  ["view-bottom", "Bottom"],
];

function Side({ command, label }: { readonly command: CommandId; readonly label: string }) {
  const name = useView((view) => view.viewName);
  const why = useWhyNot(command);
  const keys = keyOf(command);
  return (
    <button
      type="button"
      aria-pressed={name === label}
      aria-disabled={why ? true : undefined}
      title={why ?? `${label} (${keys})`}
      onClick={() => run(command)}
    >
      {keys?.length === 1 && (
        <span className="view-key" aria-hidden="true">
          {keys}
        </span>
      )}
      {label}
    </button>
  );
}

/** What the view is called, and the keys of the others. */
export function ViewName() {
  const name = useView((view) => view.viewName);
  const free = name === "Parallel" ? name : "Perspective";
  return (
    <fieldset className="view-name" aria-label="View">
      {SIDES.map(([command, label]) => (
        <Side key={command} command={command} label={label} />
      ))}
      <button
        type="button"
        className="view-free"
        aria-pressed={name === free}
        title="Perspective or parallel"
        onClick={() => run("view-perspective")}
      >
        <span className="view-key" aria-hidden="true">
          {keyOf("view-perspective")}
        </span>
        {free}
      </button>
      <button type="button" onClick={() => run("frame-all")} title="Frame everything (Home)">
        <span className="view-key" aria-hidden="true">
          {keyOf("frame")}
        </span>
        Frame
      </button>
    </fieldset>
  );
}
