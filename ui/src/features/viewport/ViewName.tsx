import { run, useWhyNot } from "../../state/window/commands";
import { type CommandId, keyOf } from "../../state/window/keys";
import { useView } from "../../state/window/view";
import "./viewport.css";

/** Each side above the one across from it. */
const NEAR: readonly (readonly [CommandId, string])[] = [
  ["view-front", "Front"],
  ["view-right", "Right"],
  ["view-top", "Top"],
];
const ACROSS: readonly (readonly [CommandId, string])[] = [
  ["view-back", "Back"],
  ["view-left", "Left"],
  ["view-bottom", "Bottom"],
];

function Side({ command, label, keys }: { command: CommandId; label: string; keys?: string | undefined }) {
  const name = useView((view) => view.viewName);
  const why = useWhyNot(command);
  return (
    <button
      type="button"
      aria-pressed={name === label}
      aria-disabled={why ? true : undefined}
      title={why ?? `${label} (${keyOf(command)})`}
      onClick={() => run(command)}
    >
      {/* The second row has the same keys with Ctrl: an empty place keeps its names below the others. */}
      <span className="view-key" aria-hidden="true">
        {keys}
      </span>
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
      {NEAR.map(([command, label]) => (
        <Side key={command} command={command} label={label} keys={keyOf(command)} />
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
      {ACROSS.map(([command, label]) => (
        <Side key={command} command={command} label={label} />
      ))}
      <button type="button" onClick={() => run("frame-all")} title="Frame everything (Home)">
        <span className="view-key" aria-hidden="true">
          {keyOf("frame")}
        </span>
        Frame
      </button>
    </fieldset>
  );
}
