import type { NoteReport } from "../../generated/responses";
import { errorText } from "../../platform/error_text";

/** What was merged, left out or assumed. */
export function Notes({ notes }: { readonly notes: readonly NoteReport[] }) {
  return notes.map((note) => (
    <p key={note.code + note.message} className="muted small">
      {errorText(note)}
    </p>
  ));
}
