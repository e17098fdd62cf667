import type { HeadReport } from "../../../generated/responses";
import { short, unitName, unitSize } from "../../../shared/figures/format";
import { useUnit } from "../../../shared/figures/unit";
import { drawingOf } from "./drawing";

const WIDTH = 336;
const HEIGHT = 264;

/** The bend head to scale, with the dimensions that are edited beside it; that of the field in use is marked. */
export function HeadPicture({ head, active }: { readonly head: HeadReport | null; readonly active: string | null }) {
  const unit = useUnit();
  if (!head)
    return (
      <div className="head-picture empty muted">
        <p>No head can be drawn of these figures.</p>
      </div>
    );
  const { wire, path, pin, peg, orbit, begin, dimensions } = drawingOf(head, WIDTH, HEIGHT);
  const figure = (mm: number) => `${short(mm / unitSize(unit), 5)} ${unitName(unit)}`;
  return (
    <figure className="head-picture">
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label="The bend head from above, to scale">
        {orbit && <path className="head-orbit" d={upperHalf(orbit)} />}
        <path className="head-wire" d={path} style={{ strokeWidth: wire }} />
        <path className="head-centreline" d={path} />
        <circle className="head-pin" cx={pin.at[0]} cy={pin.at[1]} r={pin.radius} />
        {peg && <circle className="head-peg" cx={peg.at[0]} cy={peg.at[1]} r={peg.radius} />}
        {orbit && <Cross at={orbit.at} />}
        {dimensions.map(({ key, from, to, text, anchor, name, mm }) => (
          <g key={key} className={key === active ? "head-dimension active" : "head-dimension"} data-key={key}>
            {name === "s" && (
              <>
                <line className="head-extension" x1={begin[0]} y1={begin[1]} x2={from[0]} y2={from[1] + 4} />
                {orbit && <line className="head-extension" x1={to[0]} y1={orbit.at[1]} x2={to[0]} y2={to[1] + 4} />}
              </>
            )}
            <line x1={from[0]} y1={from[1]} x2={to[0]} y2={to[1]} />
            <circle cx={from[0]} cy={from[1]} r={2} />
            <circle cx={to[0]} cy={to[1]} r={2} />
            <text x={text[0]} y={text[1]} textAnchor={anchor}>
              {name} {figure(mm)}
            </text>
          </g>
        ))}
      </svg>
      <figcaption className="muted small">{caption(head)}</figcaption>
    </figure>
  );
}

/** The part of the orbit on the side of the bend. */
const upperHalf = ({ at: [x, y], radius }: { readonly at: readonly [number, number]; readonly radius: number }) =>
  `M ${x - radius} ${y} A ${radius} ${radius} 0 0 1 ${x + radius} ${y}`;

function caption({ peg, wire_mm }: HeadReport): string {
  const wire = `with ${short(wire_mm)} mm wire`;
  if (!peg) return `To scale, ${wire}: the axis itself makes the bend.`;
  if (peg.axis_deg === null) return `To scale, ${wire}. The peg does not reach a right angle.`;
  return `To scale, ${wire} bent to 90°: the axis is at ${short(peg.axis_deg, 4)}°.`;
}

function Cross({ at: [x, y] }: { readonly at: readonly [number, number] }) {
  return (
    <g className="head-cross">
      <line x1={x - 5} y1={y} x2={x + 5} y2={y} />
      <line x1={x} y1={y - 5} x2={x} y2={y + 5} />
    </g>
  );
}
