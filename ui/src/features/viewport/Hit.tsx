import { sentence } from "../../shared/figures/format";
import { Mark } from "../../shared/lists/Mark";
import { metAt, useContacts } from "../../state/program/contacts";
import { usePlayback } from "../../state/program/program";

/** What the wire hits or comes near where the program stands, in a line at the foot of the view. */
export function Hit() {
  const { contacts } = useContacts();
  const { played, step } = usePlayback();
  const [last, ...others] = played ? metAt(contacts, step) : [];
  const more = others.length > 0 ? ` (and ${others.length} more in this step)` : "";
  return (
    <div role="status" aria-label="What the wire meets">
      {last && (
        <p className={`hit ${last.finding.severity}`}>
          <Mark tone={last.finding.severity} />
          <span>
            {sentence(last.finding.message)}
            {more}
          </span>
        </p>
      )}
    </div>
  );
}
