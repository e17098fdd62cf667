import type { RunFileReport } from "../../generated/responses";
import { Button } from "../../shared/controls/Button";
import { Checkbox } from "../../shared/controls/inputs";
import { useUnit } from "../../shared/figures/unit";
import { Line } from "../../shared/lists/Line";
import { useCollisions } from "../../state/design/collisions";
import { useDesign } from "../../state/design/design";
import { type Missing, type PlayedContact, setStops, useContacts, useStops } from "../../state/program/contacts";
import { jump } from "../../state/program/player";
import { usePlayback } from "../../state/program/program";
import { useRunFile } from "../../state/program/run_file";
import { useUi } from "../../state/window/ui";
import { EnterDimensions } from "../check/EnterDimensions";
import { estimatesOf } from "../check/texts";
import { Avoid } from "./Avoid";
import { CollisionSettings } from "./CollisionSettings";
import { depthOf, elsewhereOf, hitOf } from "./hits";

/** The wire as made lies elsewhere by what is said above. */
const OF_DESIGNED = "Collisions are those of the wire as designed. The wire as made may hit elsewhere.";

/** Where the wire hits something, and whether playing stops there. */
export function Contacts() {
  const { missing, contacts, elsewhere } = useContacts();
  const file = useRunFile((run) => run.file);
  const stops = useStops(({ on }) => on);
  const shown = usePlayback((playback) => playback.shown);
  const others = elsewhereOf(elsewhere);
  const hit = contacts.some(({ depth_mm }) => depth_mm >= 0);
  if (file) return <OfFile kind={file.kind} />;
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
      {hit ? <Estimates contacts={contacts} /> : <Nothing missing={missing} others={elsewhere.hits > 0} />}
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

/** Why there are none. `missing`: what of the design as it is, is not there yet; `others`: other wires have some. */
function Nothing({ missing, others }: { readonly missing: Missing | null; readonly others: boolean }) {
  const { stands } = useCollisions();
  const found = useDesign(({ collisions }) => collisions?.found);
  // What was found a moment ago stays until the next answer is there.
  const done = stands === "done" && missing !== "collisions";
  const checked = done && !missing && found?.checked ? found : null;
  const checking = !done && (found || stands === "running" || stands === "waiting");
  const text = (): string => {
    if (checked) {
      const none = others ? "No collision of this wire found." : "No collision found.";
      return [none, estimatesOf(checked)].filter(Boolean).join(" ");
    }
    if (checking) return "Checking for collisions…";
    return done && missing ? "Waiting for the program…" : "Collisions are not checked.";
  };
  return (
    <p className="two-lines muted small">
      {text()} {checked && checked.estimates > 0 && <EnterDimensions />}
    </p>
  );
}

/** What is said of a file that is run is said in *Run*. */
function OfFile({ kind }: Pick<RunFileReport, "kind">) {
  const showSection = useUi((ui) => ui.showSection);
  if (kind === "moves") return <p className="muted small">Recorded moves are not checked for collisions.</p>;
  return (
    <p className="muted small">
      <Button kind="link" aria-controls="section-run" onClick={() => showSection("run")}>
        Run
      </Button>{" "}
      shows what the checks say of this file.
    </p>
  );
}
