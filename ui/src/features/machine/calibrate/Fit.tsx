import type { KindReport, ParameterReport } from "../../../generated/responses";
import { Segmented } from "../../../shared/controls/inputs";
import { number } from "../../../shared/figures/format";
import { useUnit } from "../../../shared/figures/unit";
import { Line } from "../../../shared/lists/Line";
import { Scrolls } from "../../../shared/lists/Scrolls";
import { chooseShape, type SpringbackShape, useCalibration } from "../../../state/calibration/calibration";
import { residualsOf } from "./residuals";
import { figure, KINDS, off, summary } from "./words";

/** What the springback may be. */
const SHAPES: Readonly<Record<string, string>> = {
  constant: "one angle",
  moved: "the profile's curve, moved",
  curve: "a curve",
};

/** What the readings tell, how well, and what they do not tell. */
export function Fit() {
  const { report, shape, gap } = useCalibration();
  const unit = useUnit();
  if (!report) return <p className="muted">{gap ?? "There are no readings yet."}</p>;
  const bends = report.kinds.find(({ kind }) => kind === "bends");
  return (
    <Scrolls className="calibrate-fit" label="What the readings tell">
      {bends && (
        <div className="row wrap">
          <span className="muted">Springback as</span>
          <Segmented<SpringbackShape>
            label="Springback as"
            value={shape}
            choices={[
              { value: "better", label: "Better" },
              { value: "constant", label: "One angle" },
              { value: "moved", label: "Profile's curve, moved" },
              { value: "curve", label: "Curve" },
            ]}
            onChoose={(chosen) => void chooseShape(chosen)}
          />
          <span className="muted small">
            {/* Beside the choice, which keeps its width. */}
            {report.shape && report.shape !== shape && `${SHAPES[report.shape] ?? report.shape}: `}
            for an angle that it has not seen it is {off(bends.leave_one_out.rms, "deg", unit)} off
            {report.other_shape &&
              report.other_shape_name &&
              `, ${off(report.other_shape.rms, "deg", unit)} as ${SHAPES[report.other_shape_name] ?? report.other_shape_name}`}
          </span>
        </div>
      )}
      {report.kinds.map((kind) => (
        <Kind key={kind.kind} kind={kind} />
      ))}
      {(report.left_out.length > 0 || report.doubts.length > 0 || report.gaps.length > 0) && (
        <section aria-label="What is not used or not known">
          <ul>
            {report.left_out.map(({ line, reading, coupon, message }) => (
              <Line
                key={`${line} ${reading}`}
                tone="warning"
                what={`Left out: ${coupon}, reading ${reading}`}
                sub={`${message}. Measure it again.`}
              />
            ))}
            {report.doubts.map((text) => (
              <Line key={text} tone="warning" what={text} />
            ))}
            {report.gaps.map((text) => (
              <Line key={text} tone="info" what={text} />
            ))}
          </ul>
        </section>
      )}
    </Scrolls>
  );
}

function Kind({ kind }: { readonly kind: KindReport }) {
  const unit = useUnit();
  const title = KINDS[kind.kind];
  return (
    <section className="calibrate-kind" aria-label={title}>
      <header className="calibrate-kind-head">
        <h3>{title}</h3>
        <span className="muted">{summary(kind, unit)}</span>
      </header>
      <table className="calibrate-parameters">
        <thead>
          <tr>
            <th scope="col">Parameter</th>
            <th scope="col">Found</th>
            <th scope="col" title="With 95 % the true value is this near">
              ± 95 %
            </th>
            <th scope="col">Was</th>
          </tr>
        </thead>
        <tbody>
          {kind.parameters.map((parameter) => (
            <Parameter key={parameter.name} parameter={parameter} />
          ))}
        </tbody>
      </table>
      <div className="stack">
        <Residuals kind={kind} />
        <BeforeAfter kind={kind} />
      </div>
    </section>
  );
}

function Parameter({ parameter }: { readonly parameter: ParameterReport }) {
  const lengths = useUnit();
  const { name, unit, value, within_95, before, identified, left } = parameter;
  return (
    <tr className={identified ? undefined : "unknown"}>
      <th scope="row">
        {name}
        {!identified && (
          <span
            className="calibrate-unknown"
            title={left ? "It is left as it was in the profile" : "These readings tell it only together with others"}
          >
            not determined
          </span>
        )}
      </th>
      <td>{figure(value, unit, lengths)}</td>
      <td className="muted">± {figure(within_95, unit, lengths)}</td>
      <td className="muted">{figure(before, unit, lengths)}</td>
    </tr>
  );
}

const WIDTH = 320;
const HEIGHT = 132;

/** What is left between readings and model. A pattern in it is something that the model does not have. */
function Residuals({ kind }: { readonly kind: KindReport }) {
  const unit = useUnit();
  const { points, zero, band, most, ends } = residualsOf(kind, WIDTH, HEIGHT);
  const what = kind.unit === "deg" ? "°" : " mm";
  const most_text = off(most, kind.unit, unit);
  return (
    <figure className="residuals">
      <svg
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        role="img"
        aria-label={`What is left of ${KINDS[kind.kind].toLowerCase()}: at most ${most_text}`}
      >
        <rect className="residuals-band" x={0} y={zero - band} width={WIDTH} height={2 * band} />
        <line className="residuals-zero" x1={0} y1={zero} x2={WIDTH} y2={zero} />
        {points.map(({ key, x, y, off: left }) => (
          <circle key={key} className="residuals-point" cx={x} cy={y} r={4}>
            <title>{off(left, kind.unit, unit)}</title>
          </circle>
        ))}
        <text x={WIDTH / 2} y={14} textAnchor="middle">
          +{most_text}
        </text>
        <text x={WIDTH / 2} y={HEIGHT - 6} textAnchor="middle">
          −{most_text}
        </text>
      </svg>
      <figcaption className="muted small">
        Read less fitted, by what was commanded: {number(ends[0], 0)}
        {what} to {number(ends[1], 0)}
        {what}. The band is the scatter.
      </figcaption>
    </figure>
  );
}

/** How far readings are off on average, with the profiles as they are and as they will be. */
function BeforeAfter({ kind }: { readonly kind: KindReport }) {
  const unit = useUnit();
  const most = Math.max(kind.before.mean_abs, kind.after.mean_abs, 1e-9);
  return (
    <>
      <dl className="before-after">
        {(
          [
            ["Off before", kind.before.mean_abs, "before"],
            ["Off after", kind.after.mean_abs, "after"],
          ] as const
        ).map(([label, value, className]) => (
          <div key={label}>
            <dt>{label}</dt>
            <dd>
              <span className={`before-after-bar ${className}`} style={{ width: `${(value / most) * 100}%` }} />
            </dd>
            <dd className="figure">{off(value, kind.unit, unit)}</dd>
          </div>
        ))}
      </dl>
      <p className="muted small" title="Leave-one-out, root mean square">
        For what it has not seen: {off(kind.leave_one_out.rms, kind.unit, unit)} off
      </p>
    </>
  );
}
