import { run } from "../../state/window/commands";
import { type CommandId, keyOf } from "../../state/window/keys";
import { useView } from "../../state/window/view";
import "./viewport.css";

const SIDES: readonly (readonly [CommandId, string])[] = [
  ["view-front", "Front"],
  ["view-right", "Right"],
  ["view-top", "Top"],
];

/** What the view is called, and the keys of the others. */
export function ViewName() {
  const name = useView((view) => view.viewName);
  const free = name === "Parallel" ? name : "Perspective";
  const views = [...SIDES, ["view-perspective", free] as const];
  return (
    <fieldset className="view-name" aria-label="View">
      {views.map(([command, label]) => (
        <button
          key={command}
          type="button"
          className={command === "view-perspective" ? "view-free" : undefined}
          aria-pressed={name === label}
          title={command === "view-perspective" ? "Perspective or parallel" : undefined}
          onClick={() => run(command)}
        >
          <span className="view-key" aria-hidden="true">
            {keyOf(command)}
          </span>
          {label}
        </button>
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
