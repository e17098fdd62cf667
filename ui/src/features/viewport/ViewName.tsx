import { keyOf } from "../../state/keys";
import { useView } from "../../state/view";
import "./viewport.css";

const VIEWS = [
  ["1", "front", "Front"],
  ["3", "right", "Right"],
  ["7", "top", "Top"],
  ["5", "perspective", "Perspective"],
] as const;

/** What the view is called, and the keys of the others. */
export function ViewName() {
  const name = useView((view) => view.viewName);
  const handle = useView((view) => view.handle);
  return (
    <div className="view-name" role="group" aria-label="View">
      {VIEWS.map(([key, view, label]) => (
        <button key={view} type="button" aria-pressed={name === label} onClick={() => handle?.view(view)}>
          <span className="view-key" aria-hidden="true">
            {key}
          </span>
          {label}
        </button>
      ))}
      <button type="button" onClick={() => handle?.frame()} title="Frame everything (Home)">
        <span className="view-key" aria-hidden="true">
          {keyOf("frame")}
        </span>
        Frame
      </button>
    </div>
  );
}
