import { useMemo } from "react";
import { Button } from "../../shared/controls/Button";
import { count } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { movedOf, usualScale } from "../../state/frame/figures";
import { useFrame } from "../../state/frame/frame";
import { showFrame, useShape } from "../../state/frame/shape";
import { gradientOf } from "./ramp";
import { drawnFrame } from "./struts";
import { COLOURED, endsOf, enlarged, viewName } from "./words";
import "./frame.css";

/** What the colours of a frame in the view mean, and how much its displacements are enlarged. */
export function Legend() {
  const shown = useFrame(({ answer }) => answer?.value ?? null);
  const view = useShape((shape) => shape.view);
  const coloured = useShape((shape) => shape.coloured);
  const scale = useShape((shape) => shape.scale);
  const unit = useUnit();
  const legend = useMemo(
    () => (shown && view ? drawnFrame(shown, view, coloured)?.legend : null),
    [shown, view, coloured],
  );
  if (!shown || !view || !legend) return null;
  const moved = movedOf(shown, view);
  const ends = legend.relative ? ["at rest", "", "moves most"] : endsOf(legend.coloured, legend.most, unit);
  return (
    <section className="frame-legend" aria-label="Legend">
      <div className="frame-legend-title">
        <strong className="grow ellipsis">{viewName(view, shown)}</strong>
        <Button
          kind="quiet"
          small
          icon="close"
          aria-label="Back to the design"
          title="Back to the design"
          onClick={() => showFrame(null)}
        />
      </div>
      <span className="muted small">
        {COLOURED[legend.coloured]}
        {!legend.relative && moved && ` · drawn at ${enlarged(scale ?? usualScale(moved))}`}
        {legend.unknown > 0 && ` · not known of ${count(legend.unknown, "strut")}`}
      </span>
      <div
        className="frame-legend-bar"
        style={{ background: gradientOf(legend.coloured === "axial" ? "diverging" : "rising") }}
      />
      <div className="frame-legend-ends">
        {ends.map((end, place) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: left, middle and right: always these three
          <span key={place}>{end}</span>
        ))}
      </div>
      {legend.coloured === "axial" && (
        <div className="frame-legend-ends muted">
          <span>compression</span>
          <span />
          <span>tension</span>
        </div>
      )}
      {!legend.relative && <span className="muted small">The ring marks the largest.</span>}
    </section>
  );
}
