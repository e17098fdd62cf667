import type { AvoidedCollisions, DiagnosticReport, Fix } from "../../generated/responses";
import { Button } from "../../shared/controls/Button";
import { Bar } from "../../shared/controls/inputs";
import { number, sentence } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { Line } from "../../shared/lists/Line";
import { useWork } from "../../state/asking/work";
import { useDesign } from "../../state/design/design";
import {
  avoidCollisions,
  endAvoiding,
  useAvoiding,
  useSearchSettings,
  weighsNothing,
} from "../../state/design/fixes/avoiding";
import { FixList } from "../check/FixList";
import { showPlaces } from "../check/places";
import { cutsOf, foundSoFar, inVainOf, isUnsearched, obstacleOf, reachOf, unsearchedOf } from "../check/search_texts";
import { metOf } from "../check/totals";
import { SearchSettings } from "./SearchSettings";

/** Another order of the bends, so that nothing is hit. */
export function Avoid() {
  const found = useDesign(({ collisions }) => collisions?.found);
  const avoiding = useAvoiding((store) => store.avoiding);
  const weightless = useSearchSettings(weighsNothing);
  const wires = useSearchSettings((settings) => settings.wires);
  const mine = avoiding !== null && avoiding.of === found ? avoiding : null;
  // Only other wires have other bends that nothing avoids.
  const inVain = mine?.outcome && mine.wires === wires && isUnsearched(mine.outcome);
  const why = weightless
    ? "One of the weights of the search has to be more than 0."
    : inVain
      ? "Nothing would be searched again: see in Check what can be done about the bends that no order avoids."
      : null;
  if (mine && !mine.outcome) return <Underway ending={mine.ending} />;
  return (
    <>
      {mine?.outcome && <Outcome outcome={mine.outcome} />}
      <div>
        <Button small why={why} onClick={() => void avoidCollisions()}>
          {mine ? "Search again" : "Avoid collisions"}
        </Button>
      </div>
      <SearchSettings />
    </>
  );
}

/** How far the search is, what it has found, and a way to end it. */
function Underway({ ending }: { readonly ending: boolean }) {
  const work = useWork(({ works }) => works.get("avoid-collisions"));
  const stage = work?.stage ? `${sentence(work.stage)}…` : "Searching…";
  const unit = useUnit();
  const far = work && work.of > 0 ? `${number(work.done, 0)} of at most ${number(work.of, 0)} steps checked` : "";
  return (
    <section className="stack" aria-label="Search for an order of the bends">
      <span className="small">{stage}</span>
      <Bar done={work?.done ?? 0} of={work?.of ?? 0} label={stage} />
      <div className="row">
        <Button
          small
          why={ending ? "The search is being ended." : null}
          title="Takes the best order that was found so far, if it hits less"
          onClick={endAvoiding}
        >
          Stop
        </Button>
        <span className="muted small">{far}</span>
      </div>
      <p className="two-lines small">{work?.found && foundSoFar(work.found, unit)}</p>
    </section>
  );
}

/** What was found where it is not taken at once, or why nothing was and what helps. */
function Outcome({ outcome }: { readonly outcome: AvoidedCollisions }) {
  const { found, best, unfound, helps, ended } = outcome;
  const notes = new Map<Fix, string | null>(helps.map(({ help, fix }) => [fix, cutsOf(help)]));
  const list = (fixes: readonly Fix[]) => (
    <FixList fixes={fixes} isOld={() => false} note={(fix) => notes.get(fix) ?? null} />
  );
  if (found) {
    if (best) return list([best]);
    return <p className="muted small">With the order that was found the checks find more errors. It is not taken.</p>;
  }
  return (
    <>
      <ul aria-label="What was in the way">
        {unfound.map((report) => (
          <Unfound key={report.vertex ?? "all"} report={report} />
        ))}
      </ul>
      {ended && !best && <p className="muted small">The search was ended. Nothing found until then hits less.</p>}
      {helps.length > 0 && (
        <>
          <p className="small">
            {helps.length === 1 ? "This was tried and hits nothing:" : "These were tried and hit nothing:"}
          </p>
          {list(helps.map(({ fix }) => fix))}
        </>
      )}
      {best && (
        <>
          <p className="small">This was found: {metOf(best.after)}.</p>
          {list([best])}
        </>
      )}
      <p className="muted small">
        {isUnsearched(outcome) ? "Check says what can be done about them." : "Check may have other fixes."}
      </p>
    </>
  );
}

/** A part of the design for which nothing was found. */
function Unfound({ report }: { readonly report: DiagnosticReport }) {
  const { search } = report;
  const unit = useUnit();
  const unsearched = unsearchedOf(report);
  const title = unsearched?.where ?? obstacleOf(report, unit);
  const vain = search && !unsearched ? [reachOf(search), ...inVainOf(search)] : [];
  return (
    <Line
      tone="warning"
      what={
        <>
          {unsearched?.why ?? "No order of the bends without a collision was found."}
          {title && (
            <button type="button" className="line-button" onClick={() => void showPlaces([report])}>
              {title}
            </button>
          )}
        </>
      }
      sub={vain.join(" ")}
    />
  );
}
