import { useState } from "react";
import { errorText } from "../../platform/error_text";
import { Button } from "../../shared/controls/Button";
import { Icon } from "../../shared/controls/icons";
import { count } from "../../shared/figures/format";
import { useDesign } from "../../state/design/design";
import "./start.css";

/** What was merged, ignored or assumed while the file was read: one quiet line, more on demand. */
export function OpenNotes() {
  const notes = useDesign((design) => design.notes);
  const [open, setOpen] = useState(false);
  if (notes.length === 0) return null;
  return (
    <>
      {open && (
        <ul className="open-notes-list">
          {notes.map((note) => (
            <li key={note.code + note.message}>{errorText(note)}</li>
          ))}
        </ul>
      )}
      <div className="open-notes row">
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
    </>
  );
}
