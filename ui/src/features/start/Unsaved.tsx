import { useState } from "react";
import { Button } from "../../shared/controls/Button";
import { ago, count } from "../../shared/figures/format";
import { Mark } from "../../shared/lists/Mark";
import { discard, restore, useFiles } from "../../state/files/files";
import "./start.css";

/** Offers designs that were open when the program or the computer stopped. */
export function Unsaved() {
  const unsaved = useFiles((files) => files.unsaved);
  const [later, setLater] = useState(false);
  if (later || unsaved.length === 0) return null;
  return (
    <section className="unsaved" aria-label="Unsaved designs">
      <div className="row">
        <Mark tone="warning" />
        <h2 className="grow">
          {unsaved.length === 1 ? "A design was not saved" : `${unsaved.length} designs were not saved`}
        </h2>
        <Button kind="quiet" small onClick={() => setLater(true)}>
          Later
        </Button>
      </div>
      <ul>
        {unsaved.map(({ journal, name, changes, changed_s, file }) => (
          <li key={journal} className="row">
            <span className="grow">
              <span className="ellipsis" title={file ?? undefined}>
                {name || "New design"}
              </span>{" "}
              <span className="muted">
                {count(changes, "change")}, {ago(Date.now() / 1000 - changed_s)}
              </span>
            </span>
            <Button kind="quiet" small onClick={() => void discard(journal)}>
              Discard
            </Button>
            <Button kind="primary" small onClick={() => void restore(journal)}>
              Restore
            </Button>
          </li>
        ))}
      </ul>
    </section>
  );
}
