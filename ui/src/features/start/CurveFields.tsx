import type { ShortestEdge } from "../../generated/requests";
import type { LookResponse } from "../../generated/responses";
import { Field } from "../../shared/controls/Field";
import { Checkbox } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { count, deviation } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";

/** How curves become straight edges. */
export interface Cutting {
  readonly tolerance: number;
  /** Whether edges have a least length. */
  readonly limited: boolean;
  /** That length, mm. */
  readonly shortest: number;
}

/** What a machine can make, if there is one: its shortest edge, up to the next tenth. */
export function cuttingFor({ machine_edges }: Pick<LookResponse, "machine_edges">): Cutting {
  const shortest = machine_edges ? Math.ceil(machine_edges.shortest_edge_mm * 10 - 1e-6) / 10 : 10;
  return { tolerance: 0.1, limited: Boolean(machine_edges), shortest };
}

/** The same for a request. */
export function asInput({ tolerance, limited, shortest }: Cutting): {
  tolerance_mm: number;
  shortest_edge?: ShortestEdge;
} {
  return { tolerance_mm: tolerance, ...(limited ? { shortest_edge: { mm: shortest } } : {}) };
}

/** Tolerance and shortest edge of curves, and what comes of them. */
export function CurveFields({
  cutting,
  look,
  pending,
  onChange,
}: {
  readonly cutting: Cutting;
  readonly look: LookResponse;
  /** Whether `look` is of other choices, since the answer for these is not there yet. */
  readonly pending: boolean;
  readonly onChange: (cutting: Cutting) => void;
}) {
  const { length, name } = useLengths();
  const { machine, machine_edges } = look;
  const own = machine_edges && Math.abs(cuttingFor(look).shortest - cutting.shortest) < 0.05;
  const hint =
    machine && machine_edges
      ? `${
          own
            ? `What ${machine} can make between bends of up to 90°.`
            : `${machine} can make ${length(machine_edges.shortest_edge_mm)} between bends of up to 90°.`
        } Its bend radius is ${length(machine_edges.bend_radius_mm)}.`
      : "Choose a machine to use its limit.";
  return (
    <>
      <Field label="Tolerance" hint={`How far straight edges may be from a drawn curve, ${name}.`}>
        {({ id }) => (
          <NumberField
            id={id}
            label="Tolerance"
            value={cutting.tolerance}
            positive
            min={1e-3}
            max={100}
            onCommit={(tolerance) => onChange({ ...cutting, tolerance })}
          />
        )}
      </Field>
      <Field label="Shortest edge" hint={hint}>
        {({ id }) => (
          <div className="curve-limit">
            <NumberField
              id={id}
              label="Shortest edge"
              value={cutting.shortest}
              min={0.1}
              max={1000}
              why={cutting.limited ? null : "Curves are cut to the tolerance alone."}
              onCommit={(shortest) => onChange({ ...cutting, shortest })}
            />
            <Checkbox checked={cutting.limited} onChange={(limited) => onChange({ ...cutting, limited })}>
              Limit edge length
            </Checkbox>
          </div>
        )}
      </Field>
      <Outcome cutting={cutting} look={look} pending={pending} />
    </>
  );
}

function Outcome({
  cutting,
  look,
  pending,
}: {
  readonly cutting: Cutting;
  readonly look: LookResponse;
  readonly pending: boolean;
}) {
  const { unit } = useLengths();
  const curves = pending ? null : look.curves;
  // Without a least length the tolerance is kept everywhere.
  const off = curves ? deviation(curves.deviation_mm, unit) : `up to ${deviation(cutting.tolerance, unit)}`;
  const tone = curves && (curves.coarser > 0 || curves.too_short > 0) ? "curve-outcome coarse" : "curve-outcome";
  return (
    <div role="status" aria-label="Result">
      <dl className={tone}>
        <div>
          <dt>Largest deviation</dt>
          <dd>{pending ? "…" : off}</dd>
        </div>
        <div>
          <dt>Result</dt>
          <dd>{pending ? "…" : `${count(look.edges, "edge")}, ${count(look.bends, "bend")}`}</dd>
        </div>
      </dl>
    </div>
  );
}
