import { Checkbox } from "../../shared/controls/inputs";
import { useUnit } from "../../shared/figures/unit";
import { Line } from "../../shared/lists/Line";
import { useCollisions } from "../../state/design/collisions";
import { useDesign } from "../../state/design/design";
import { type PlayedContact, setStops, useContacts, useStops } from "../../state/program/contacts";
import { jump } from "../../state/program/player";
import { usePlayback } from "../../state/program/program";
import { EnterDimensions } from "../check/EnterDimensions";
import { estimatesOf } from "../check/texts";
import { Avoid } from "./Avoid";
import { CollisionSettings } from "./CollisionSettings";
import { depthOf, elsewhereOf, hitOf } from "./hits";

/** The wire as made lies elsewhere by what is said above. */
const OF_DESIGNED = "Collisions are those of the wire as designed. The wire as made may hit elsewhere.";

/** Where the wire hits something, and whether playing stops there. */
export function Contacts() {
  const { contacts, elsewhere } = useContacts();
  const stops = useStops(({ on }) => on);
  const shown = usePlayback((playback) => playback.shown);
  const others = elsewhereOf(elsewhere);
  const hit = contacts.some(({ depth_mm }) => depth_mm >= 0);
  return (
    <div className="stack">
      <Checkbox checked={stops} onChange={setStops}>
        Stop at collisions
      </Checkbox>
      {contacts.length > 0 && (
        <ul className="animate-contacts" aria-label={hit ? "Collisions" : "Places nearer than the clearance"}>
          {contacts.map((contact) => (
            <Contact key={`${contact.step} ${contact.body}`} contact={contact} />
          ))}
        </ul>
      )}
      {hit ? <Estimates contacts={contacts} /> : <Nothing others={elsewhere.hits > 0} />}
      <CollisionSettings />
      {shown !== "designed" && <p className="muted small">{OF_DESIGNED}</p>}
      {(contacts.length > 0 || others) && <Avoid />}
      {others && <p className="muted small">{others}</p>}
    </div>
  );
}

function Contact({ contact }: { readonly contact: PlayedContact }) {
  const unit = useUnit();
  const live = usePlayback((playback) => playback.live);
  const what = hitOf(contact);
  return (
    <Line
      tone={contact.finding.severity}
      what={
        <button type="button" className="line-button" disabled={live} onClick={() => jump(contact.position)}>
          {what}
        </button>
      }
      sub={depthOf(contact, unit)}
    />
  );
}

/** How many bodies are not measured, once for all of the list. */
function Estimates({ contacts }: { readonly contacts: readonly PlayedContact[] }) {
  const found = useDesign(({ collisions }) => collisions?.found);
  const text = found && estimatesOf(found);
  return text ? (
    <p className="muted small">
      {text} {found.estimates > 0 && <EnterDimensions body={hitFirst(contacts)} />}
    </p>
  ) : null;
}

/** The first body that is hit and not measured. */
const hitFirst = (contacts: readonly PlayedContact[]): string | null =>
  contacts.find(({ estimated }) => estimated)?.finding.body ?? null;

/** Why there are none. `others`: other wires have some. */
function Nothing({ others }: { readonly others: boolean }) {
  const { stands } = useCollisions();
  const found = useDesign(({ collisions }) => collisions?.found);
  const text = found?.checked
    ? [others ? "No collision of this wire found." : "No collision found.", estimatesOf(found)]
        .filter(Boolean)
        .join(" ")
    : stands === "running" || stands === "waiting"
      ? "Checking for collisions…"
      : "Collisions are not checked.";
  return (
    <p className="two-lines muted small">
      {text} {found?.checked && found.estimates > 0 && <EnterDimensions />}
    </p>
  );
}
