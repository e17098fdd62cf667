import type { DrawnSequence } from "../../generated/responses";
import { useUnit } from "../../shared/figures/unit";
import { slideTo, stepAt } from "../../state/sequence/sequence";
import { displacement } from "../frame/words";

/** Units of the drawing, which is stretched to the width of the panel. */
const WIDTH = 400;
const HEIGHT = 96;
const TOP = 8;

/** How far what is built sags after each step, and how far it may. */
export function Curve({ drawn, at }: { readonly drawn: DrawnSequence; readonly at: number }) {
  const unit = useUnit();
  const { steps, epsilon_mm: epsilon } = drawn.sequence;
  const sags = steps.map((step) => step.max_displacement_mm ?? null);
  const most = sags.reduce<number>((most, sag) => Math.max(most, sag ?? 0), epsilon) * 1.08;
  const x = (step: number) => ((step + 0.5) / steps.length) * WIDTH;
  const y = (mm: number) => HEIGHT - (mm / most) * (HEIGHT - TOP);
  const now = stepAt(at, steps.length);
  const sag = sags[now];
  // Where it does not stand the line is broken.
  let pen = "M";
  let path = "";
  for (const [step, mm] of sags.entries()) {
    if (mm === null) pen = "M";
    else {
      path += `${pen}${x(step).toFixed(1)} ${y(mm).toFixed(1)}`;
      pen = "L";
    }
  }
  return (
    <figure className="curve">
      <figcaption className="row small">
        <span className="grow muted">Sag after each step</span>
        <span>
          step {now + 1}: {sag == null ? "does not stand" : displacement(sag, unit)}
        </span>
      </figcaption>
      <div className="curve-plot">
        {/* biome-ignore lint/a11y/useKeyWithClickEvents: the slider under the view does the same for the keyboard */}
        <svg
          viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
          preserveAspectRatio="none"
          role="img"
          aria-label={`Sag after each step, at most ${displacement(drawn.sequence.max_displacement_mm ?? 0, unit)} of ${displacement(epsilon, unit)} that are allowed`}
          onClick={(event) => {
            const box = event.currentTarget.getBoundingClientRect();
            slideTo(Math.floor(((event.clientX - box.left) / box.width) * steps.length) + 1);
          }}
        >
          <line className="curve-limit" x1={0} x2={WIDTH} y1={y(epsilon)} y2={y(epsilon)} />
          <line className="curve-now" x1={x(now)} x2={x(now)} y1={0} y2={HEIGHT} />
          <path className="curve-line" d={path} />
        </svg>
        <div className="curve-epsilon small" style={{ top: `${(y(epsilon) / HEIGHT) * 100}%` }}>
          ε {displacement(epsilon, unit)}
        </div>
      </div>
    </figure>
  );
}
