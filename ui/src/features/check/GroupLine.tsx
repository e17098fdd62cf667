import { useEffect, useRef, useState } from "react";
import type { DiagnosticReport } from "../../generated/responses";
import { Button } from "../../shared/controls/Button";
import { Either } from "../../shared/controls/Either";
import { sentence } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { Mark } from "../../shared/lists/Mark";
import { useDesign } from "../../state/design/design";
import { isCollision } from "../../state/design/findings";
import { fixesOf, useFixes } from "../../state/design/fixes/fixes";
import { highlight } from "../../state/design/selection";
import { EnterDimensions } from "./EnterDimensions";
import { FixAllOffer } from "./FixAllOffer";
import { FixList } from "./FixList";
import { placesOfAll, showPlaces } from "./places";
import { figuresOf, type Group, isEstimated, measureText, sourceOf, TONES, titleOf, whatOf, worstOf } from "./texts";
import { wayOut } from "./ways";

/** More places than these are not listed one by one. */
const MAX = 40;

/** Highlights the places while a line is pointed at or has the focus, and not longer: also where the line goes away meanwhile. */
function usePointing(reports: readonly DiagnosticReport[]) {
  const pointing = useRef(false);
  const point = (now: boolean) => {
    pointing.current = now;
    const { vertices, edges } = placesOfAll(now ? reports : []);
    highlight(vertices, edges);
  };
  useEffect(
    () => () => {
      if (pointing.current) highlight();
    },
    [],
  );
  const [on, off] = [() => point(true), () => point(false)];
  return { line: { onPointerEnter: on, onPointerLeave: off }, button: { onFocus: on, onBlur: off } };
}

/** One of several places of a kind: with its value, and its own fixes. */
function Member({ report }: { readonly report: DiagnosticReport }) {
  const [open, setOpen] = useState(false);
  const unit = useUnit();
  const fixes = fixesOf(
    report,
    useFixes((store) => store.fixes),
  );
  const pointing = usePointing([report]);
  return (
    <li {...pointing.line}>
      <div className="member">
        <button type="button" className="line-button" onClick={() => void showPlaces([report])} {...pointing.button}>
          {whatOf(report)}
        </button>
        <span className="muted member-value">{measureText(report, unit)}</span>
        {fixes.length > 0 && (
          <Button kind="link" aria-expanded={open} onClick={() => setOpen(!open)}>
            Fix…
          </Button>
        )}
      </div>
      {open && <FixList fixes={fixes} />}
    </li>
  );
}

/** Where no change is known that fixes it alone. */
const ADVICE = "Help…";

/** Diagnostics of a kind: what, value and limit, one action. */
export function GroupLine({ group }: { readonly group: Group }) {
  const { reports, severity } = group;
  const unit = useUnit();
  const [open, setOpen] = useState(false);
  const all = useFixes((store) => store.fixes);
  const [first] = reports;
  const single = reports.length === 1 && first !== undefined;
  const fixes = single ? fixesOf(first, all) : [];
  const fixable = single ? fixes.length > 0 : reports.some((report) => fixesOf(report, all).length > 0);
  const pointing = usePointing(reports);
  const stencil = useDesign(({ surfaces }) => surfaces.size > 0);
  const way = fixable ? null : wayOut(first?.code ?? "", stencil);
  const places = placesOfAll(reports);
  const somewhere = places.vertices.length + places.edges.length > 0;
  const estimated = worstOf(reports.filter(isEstimated));
  // The grey line has no room for it beside its figures.
  const help = single && first.unit ? first.help : "";
  const shown = help ? ADVICE : somewhere ? "Show" : null;
  const action = fixable ? "Fix…" : way ? way.label : single ? shown : "List";
  const folds = action !== "Show" && !way;
  return (
    <li className="line" {...pointing.line}>
      <Mark tone={TONES[severity]} />
      <div className="line-what">
        {somewhere ? (
          <button type="button" className="line-button" onClick={() => void showPlaces(reports)} {...pointing.button}>
            {titleOf(group)}
          </button>
        ) : (
          titleOf(group)
        )}
      </div>
      <div className="line-sub" title={sourceOf(group)}>
        {figuresOf(group, unit)}
      </div>
      {action && (
        <div className="line-action">
          <Button
            kind="link"
            aria-expanded={folds ? open : undefined}
            title={way?.title}
            onClick={() => (folds ? setOpen(!open) : way ? way.go() : void showPlaces(reports))}
          >
            {folds ? <Either shown={open ? "Close" : action} other={open ? action : "Close"} /> : action}
          </Button>
        </div>
      )}
      {open && folds && (
        <div className="line-more">
          {single && <FixList fixes={fixes} />}
          {!single && first && fixable && !isCollision(first.code) && <FixAllOffer code={first.code} />}
          {!single && (
            <ul className="members">
              {reports.slice(0, MAX).map((report, index) => (
                // biome-ignore lint/suspicious/noArrayIndexKey: the findings of a check come and go together
                <Member key={index} report={report} />
              ))}
              {reports.length > MAX && <li className="muted">and {reports.length - MAX} more</li>}
            </ul>
          )}
          {help && <p className="muted small">{sentence(help)}.</p>}
          {estimated && (
            <div className="row">
              <EnterDimensions body={estimated.body ?? null} />
            </div>
          )}
        </div>
      )}
    </li>
  );
}
