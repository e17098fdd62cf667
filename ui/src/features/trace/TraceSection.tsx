import { useEffect } from "react";
import type { SnapKind } from "../../scene/interface";
import { Button } from "../../shared/controls/Button";
import { Either } from "../../shared/controls/Either";
import { Field } from "../../shared/controls/Field";
import { Checkbox, Segmented, Slider } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { count, percent, roughly } from "../../shared/figures/format";
import { type DesignState, useDesign } from "../../state/design/design";
import { diameterOf, needMachines, useMachines } from "../../state/machine/machines";
import { run } from "../../state/window/commands";
import { keyOf } from "../../state/window/keys";
import { useUi } from "../../state/window/ui";
import {
  choosePlane,
  chooseTool,
  type PlaneName,
  putPlane,
  SNAP_KINDS,
  setConstructing,
  toggleSnap,
  useView,
} from "../../state/window/view";
import { Part, Section } from "../panel/Section";
import { Strand } from "./Strand";

const SNAPS: Readonly<Record<SnapKind, string>> = {
  vertex: "Vertices",
  "stencil-vertex": "Corners of the stencil",
  "stencil-edge": "Edges of the stencil",
  construction: "Construction lines",
  "edge-middle": "Middles of edges (splits them)",
  edge: "Edges (splits them)",
  surface: "Surface of the stencil",
  angle: "Directions in steps of 15° (Shift frees them)",
  grid: "Grid",
  plane: "Anywhere on the plane",
};

const NO_STENCILS: DesignState["stencils"] = [];

/** How the stencils are seen; what they are is in the section Parts. */
function Stencils({ none }: { readonly none: string | null }) {
  const { stencilsShown, stencilOpacity, stencilOffset } = useView();
  useEffect(needMachines, []);
  useMachines();
  const across = diameterOf(useDesign(({ state }) => state?.material));
  if (none !== null) {
    return (
      <div className="stack">
        <p className="muted">
          A stencil is a model to trace a wireframe on. It is for reference only and is never bent.
        </p>
        <div className="row">
          <Button icon="folder" onClick={() => run("open-stencil")}>
            Open stencil…
          </Button>
        </div>
      </div>
    );
  }
  return (
    <div className="stack">
      <Field label="Opacity">
        {() => (
          <Slider
            label="Opacity of the stencils"
            value={stencilOpacity}
            min={0.05}
            onChange={(value) => useView.setState({ stencilOpacity: value })}
            text={percent(stencilOpacity)}
          />
        )}
      </Field>
      <Field label="Surface offset" hint="How far off the stencil a click places a vertex.">
        {({ id }) => (
          <div className="row">
            <NumberField
              id={id}
              label="Surface offset"
              value={stencilOffset}
              min={0}
              max={1000}
              onCommit={(mm) => useView.setState({ stencilOffset: mm })}
            />
            <Button
              why={across === null ? "Choose a material in Machine first." : null}
              title="The wire lies on the stencil: its middle is half of its diameter off."
              onClick={() => useView.setState({ stencilOffset: (across ?? 0) / 2 })}
            >
              Half the wire
            </Button>
          </div>
        )}
      </Field>
      <div className="row wrap">
        <Button
          icon={stencilsShown ? "shown" : "hidden"}
          onClick={() => useView.setState({ stencilsShown: !stencilsShown })}
        >
          {stencilsShown ? <Either shown="Hide all" other="Show all" /> : <Either shown="Show all" other="Hide all" />}
        </Button>
        <Button aria-controls="section-parts" onClick={() => useUi.getState().showSection("parts")}>
          Place or remove…
        </Button>
      </div>
    </div>
  );
}

/** What the plane of a person's own is put on. */
function throughText(through: readonly (number | null)[]): string {
  const [a, b, c] = through;
  return through.includes(null) ? "Through three points." : `Through vertices ${a}, ${b} and ${c}.`;
}

/** Which plane is drawn on: of the axes, or on three points. As high whichever it is. */
function Plane() {
  const { tool, plane, ownPlane } = useView();
  const puts = tool === "plane";
  return (
    <Field
      label="Plane"
      hint={
        <span className="plane-hint">
          {puts
            ? "Click three points in the view, Esc ends."
            : ownPlane
              ? throughText(ownPlane.through)
              : "Points: through three selected vertices, or three clicks."}
        </span>
      }
    >
      {() => (
        <Segmented<PlaneName | "points">
          label="Plane"
          choices={[
            { value: "xy", label: "XY" },
            { value: "xz", label: "XZ" },
            { value: "yz", label: "YZ" },
            { value: "points", label: "Points" },
          ]}
          value={ownPlane || puts ? "points" : plane}
          onChoose={(value) => {
            if (value === "points") putPlane();
            else {
              if (puts) chooseTool("draw");
              choosePlane(value);
            }
          }}
        />
      )}
    </Field>
  );
}

/** The surface that is traced on, what clicks snap to, and the strand that is being drawn. */
export function TraceSection() {
  const { tool, constructing, snapKinds, grid, reach, planeOffset } = useView();
  const stencils = useDesign((design) => design.state?.stencils ?? NO_STENCILS).filter(({ surface }) => surface);
  const faces = stencils.reduce((sum, { surface }) => sum + (surface?.faces ?? 0), 0);
  const none = stencils.length === 0 ? "No stencil" : null;
  const named = stencils.length === 1 ? stencils[0]?.name : count(stencils.length, "stencil");
  const phrase = none
    ? "no stencil"
    : `${named ? `${named} · ` : ""}${roughly(faces)} ${faces === 1 ? "face" : "faces"}`;
  return (
    <Section id="trace" title="Trace" phrase={phrase}>
      <Part title="Stencils" aside={none === null && <span className="muted">{count(faces, "face")}</span>}>
        <Stencils none={none} />
      </Part>
      <Part title="Strand">
        <div className="row wrap">
          <Button
            icon="trace"
            pressed={tool === "trace"}
            onClick={() => chooseTool("trace")}
            title={`Trace (${keyOf("tool-trace")})`}
          >
            Trace
          </Button>
          <Button
            icon="draw"
            pressed={tool === "draw"}
            onClick={() => chooseTool("draw")}
            title={`Draw on a plane (${keyOf("tool-draw")})`}
          >
            Draw on a plane
          </Button>
        </div>
        <Checkbox checked={constructing} onChange={setConstructing}>
          Construction line: never bent <kbd>{keyOf("draw-construction")}</kbd>
        </Checkbox>
        <Strand />
        <Plane />
        <Field label="Offset">
          {({ id }) => (
            <NumberField
              id={id}
              label="Offset of the plane"
              value={planeOffset}
              onCommit={(mm) => useView.setState({ planeOffset: mm })}
            />
          )}
        </Field>
      </Part>
      <Part title="Clicks snap to">
        <div>
          {SNAP_KINDS.map((kind) => (
            <Checkbox
              key={kind}
              checked={snapKinds.has(kind)}
              onChange={() => toggleSnap(kind)}
              why={kind === "surface" || kind.startsWith("stencil") ? none : null}
            >
              {SNAPS[kind]}
            </Checkbox>
          ))}
        </div>
        <Field label="Grid">
          {({ id }) => (
            <NumberField
              id={id}
              label="Grid"
              value={grid}
              min={0.1}
              max={1000}
              onCommit={(mm) => useView.setState({ grid: mm })}
            />
          )}
        </Field>
        <Field label="Reach" hint="Snap distance of the pointer, in pixels.">
          {({ id }) => (
            <NumberField
              id={id}
              kind="whole"
              label="Reach"
              value={reach}
              min={4}
              max={60}
              onCommit={(px) => useView.setState({ reach: px })}
            />
          )}
        </Field>
      </Part>
    </Section>
  );
}
