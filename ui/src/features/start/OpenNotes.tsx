import { useState } from "react";
import { Button } from "../../shared/Button";
import { count } from "../../shared/format";
import { Icon } from "../../shared/icons";
import { useDesign } from "../../state/design";
import "./start.css";

/** What was merged, ignored or assumed while the file was read: one quiet line, more on demand. */
export function OpenNotes() {
  const notes = useDesign((design) => design.notes);
  const [open, setOpen] = useState(false);
  if (notes.length === 0) return null;
  return (
    <div className="open-notes">
      {open && (
        <ul>
          {notes.map(({ code, message }) => (
            <li key={code + message}>{message}</li>
          ))}
        </ul>
      )}
      <div className="row">
        <button type="button" className="open-notes-head" aria-expanded={open} onClick={() => setOpen(!open)}>
          <Icon name={open ? "down" : "right"} size={12} />
          {count(notes.length, "note")} from reading the file
        </button>
        <Button
          kind="quiet"
          icon="close"
          small
          aria-label="Dismiss the notes"
          onClick={() => {
            setOpen(false);
            useDesign.setState({ notes: [] });
          }}
        />
      </div>
    </div>
  );
}
