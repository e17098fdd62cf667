import { useState } from "react";
import type { Vec3 } from "../../scene/interface";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Fold } from "../../shared/controls/Fold";
import { Segmented, Select } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { count } from "../../shared/figures/format";
import { useSelection } from "../../state/design/selection";
import { baseName } from "../../state/files/files";
import { chooseFrame, useFrame } from "../../state/frame/frame";
import { chooseLoadCase, DOWN, dropLoads, loadCase, pickLoads, putForce } from "../../state/frame/loads";
import { Place } from "./Place";
import { caseSays, forceParts } from "./words";

const AXES = ["X", "Y", "Z"] as const;

const NONE: Vec3 = [0, 0, 0];

const replaced = (vector: Vec3, axis: number, value: number): Vec3 => {
  const [x, y, z] = vector.map((part, at) => (at === axis ? value : part));
  return [x ?? 0, y ?? 0, z ?? 0];
};

/** Gravity, forces at vertices, and loads of a file. */
export function Loads() {
  const gravity = useFrame((store) => store.gravity);
  const forces = useFrame((store) => store.forces.size);
  const loadFile = useFrame((store) => store.loadFile);
  const says = [
    WEIGHTS[presetOf(gravity)],
    forces > 0 ? count(forces, "force") : null,
    loadFile ? baseName(loadFile.path) : null,
  ];
  return (
    <Fold title="Loads" phrase={says.filter(Boolean).join(" · ")}>
      <div className="stack">
        <Gravity />
        <Forces />
        <LoadFile />
      </div>
    </Fold>
  );
}

const WEIGHTS: Readonly<Record<Preset, string>> = {
  down: "gravity down",
  none: "no gravity",
  own: "gravity elsewhere",
  file: "gravity of the file",
};

type Preset = "down" | "none" | "own" | "file";

const presetOf = (gravity: Vec3 | null): Preset =>
  gravity === null
    ? "file"
    : gravity.every((part) => part === 0)
      ? "none"
      : gravity.every((part, axis) => part === DOWN[axis])
        ? "down"
        : "own";

/** A direction and a factor: the parts are multiples of standard gravity. */
function Gravity() {
  const gravity = useFrame((store) => store.gravity);
  const loadFile = useFrame((store) => store.loadFile);
  const said = useFrame(loadCase)?.gravity ?? null;
  const shown = gravity ?? said ?? NONE;
  const preset = presetOf(gravity);
  const presets: Readonly<Record<Preset, Vec3 | null>> = { down: DOWN, none: NONE, own: shown, file: null };
  return (
    <>
      <Field label="Gravity" stacked>
        {() => (
          <Segmented<Preset>
            label="Gravity"
            value={preset}
            choices={[
              { value: "down", label: "Down" },
              { value: "none", label: "None" },
              { value: "own", label: "Other", why: preset === "own" ? null : "Type it in the fields below." },
              { value: "file", label: "Of the file", why: loadFile ? null : "No load file is chosen." },
            ]}
            onChoose={(chosen) => chooseFrame({ gravity: presets[chosen] })}
          />
        )}
      </Field>
      <div className="frame-three">
        {AXES.map((name, axis) => (
          <NumberField
            key={name}
            label={`Gravity along ${name}, times standard gravity`}
            prefix={name}
            kind="number"
            value={shown[axis] ?? 0}
            min={-1000}
            max={1000}
            onCommit={(value) => chooseFrame({ gravity: replaced(shown, axis, value) })}
          />
        ))}
      </div>
    </>
  );
}

/** Forces that a person puts on vertices. */
function Forces() {
  const forces = useFrame((store) => store.forces);
  const selected = useSelection(({ vertices }) => vertices);
  const [force, setForce] = useState<Vec3>([0, 0, -1]);
  const why =
    selected.size === 0
      ? "Select the vertices on which it acts."
      : force.every((part) => part === 0)
        ? "A force of 0 does nothing."
        : null;
  return (
    <>
      <Field label="Force" stacked>
        {() => (
          <div className="frame-three">
            {AXES.map((name, axis) => (
              <NumberField
                key={name}
                label={`Force along ${name}`}
                prefix={name}
                kind="number"
                unit="N"
                value={force[axis] ?? 0}
                min={-1e9}
                max={1e9}
                onCommit={(value) => setForce(replaced(force, axis, value))}
              />
            ))}
          </div>
        )}
      </Field>
      <div className="row">
        <span className="grow muted small">
          {forces.size === 0 ? "No forces at vertices." : count(forces.size, "force")}
        </span>
        <Button small icon="plus" why={why} onClick={() => putForce(selected, force)}>
          Put on selected
        </Button>
      </div>
      {forces.size > 0 && (
        <ul className="frame-forces" aria-label="Forces">
          {[...forces].map(([vertex, parts]) => (
            <li key={vertex}>
              <Place vertex={vertex} />
              <span className="grow ellipsis">{forceParts(parts)}</span>
              <Button
                kind="quiet"
                small
                icon="close"
                aria-label={`Remove the force at vertex ${vertex}`}
                title="Remove"
                onClick={() => putForce([vertex], NONE)}
              />
            </li>
          ))}
        </ul>
      )}
    </>
  );
}

/** Loads of a file, and which of its cases acts. */
function LoadFile() {
  const loadFile = useFrame((store) => store.loadFile);
  const acts = useFrame(loadCase);
  return (
    <>
      <div className="field frame-file">
        <span className="field-name">Load file</span>
        <span className="row">
          <span className={loadFile ? "grow ellipsis" : "grow muted"} title={loadFile?.path}>
            {loadFile ? baseName(loadFile.path) : "none"}
          </span>
          {loadFile && (
            <Button
              kind="quiet"
              small
              icon="close"
              aria-label="No load file"
              title="No load file"
              onClick={dropLoads}
            />
          )}
          <Button small title="Load cases as conmech writes them" onClick={() => void pickLoads()}>
            Load file…
          </Button>
        </span>
      </div>
      {loadFile && acts && (
        <>
          <Field label="Load case">
            {(ids) => (
              <Select
                {...ids}
                value={loadFile.chosen}
                choices={loadFile.cases.map(({ name }) => ({ value: name, label: name }))}
                onChoose={chooseLoadCase}
              />
            )}
          </Field>
          <p className="muted small">{caseSays(acts)}</p>
        </>
      )}
    </>
  );
}
