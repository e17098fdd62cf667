import { useEffect } from "react";
import { Button } from "../../shared/controls/Button";
import { Either } from "../../shared/controls/Either";
import { Field } from "../../shared/controls/Field";
import { Checkbox, Segmented, Select } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { count } from "../../shared/figures/format";
import { useDesign } from "../../state/design/design";
import { useSelection } from "../../state/design/selection";
import {
  chooseFrame,
  type Hold,
  needFrameChoices,
  setPicking,
  toggleSupports,
  useFrame,
} from "../../state/frame/frame";
import { needMachines, useMachines } from "../../state/machine/machines";
import { Part } from "../panel/Section";
import { Faces } from "./Faces";
import { Loads } from "./Loads";

/** Material, supports and loads. */
export function Setup() {
  const { material, hold, modes, bow } = useFrame();
  const own = useDesign(({ state }) => state?.material ?? null);
  const held = useDesign(({ vertices }) => [...vertices.values()].filter(({ support }) => support).length);
  const chosen = useFrame((frame) => frame.chosen.size);
  const materials = useMachines((machines) => machines.materials);
  useEffect(() => {
    needMachines();
    needFrameChoices();
  }, []);
  const nameOf = (id: string) => materials?.find((entry) => entry.id === id)?.name ?? id;
  return (
    <div className="stack">
      <Field label="Material">
        {(ids) => (
          <Select
            {...ids}
            value={material ?? ""}
            choices={[
              { value: "", label: own ? `Of the design: ${nameOf(own)}` : "Of the design" },
              ...(materials ?? []).map(({ id, name }) => ({ value: id, label: name })),
            ]}
            onChoose={(id) => chooseFrame({ material: id || null })}
          />
        )}
      </Field>
      <Field label="Held" stacked>
        {() => (
          <Segmented<Hold>
            label="Held"
            value={hold}
            choices={[
              { value: "design", label: `Design (${held})` },
              { value: "chosen", label: `Chosen (${chosen})` },
              { value: "free", label: "Free" },
            ]}
            onChoose={(value) => {
              chooseFrame({ hold: value });
              setPicking(false);
            }}
          />
        )}
      </Field>
      <Supports />
      <Loads />
      <Field label="Modes">
        {(ids) => (
          <NumberField
            {...ids}
            label="Modes"
            kind="whole"
            value={modes}
            min={0}
            max={100}
            onCommit={(value) => chooseFrame({ modes: value })}
          />
        )}
      </Field>
      <Field label="Bow of struts">
        {(ids) => (
          <NumberField
            {...ids}
            label="Bow of struts, as a share of their length"
            kind="percent"
            why={modes === 0 ? "A bow changes modes alone, and none are looked for." : null}
            value={bow}
            min={0}
            max={0.5}
            onCommit={(value) => chooseFrame({ bow: value })}
          />
        )}
      </Field>
    </div>
  );
}

/** Supports that a person chooses. Its place is kept while others hold the frame. */
function Supports() {
  const { hold, picking, chosen } = useFrame();
  // Unseen, clicks in the view would go on choosing supports.
  useEffect(() => () => setPicking(false), []);
  const selected = useSelection(({ vertices }) => vertices);
  const why = hold === "chosen" ? null : "Supports are chosen under Chosen.";
  return (
    <div className="row">
      <Button
        small
        pressed={picking}
        why={why}
        title="Click vertices in the view; click again to let go"
        onClick={() => setPicking(!picking)}
      >
        {picking ? (
          <Either shown="Click vertices…" other="Pick in the view" />
        ) : (
          <Either shown="Pick in the view" other="Click vertices…" />
        )}
      </Button>
      <Button
        small
        why={why ?? (selected.size === 0 ? "No vertex is selected." : null)}
        onClick={() => toggleSupports([...selected].filter((id) => !chosen.has(id)))}
      >
        Add selected
      </Button>
      <Button
        small
        why={why ?? (chosen.size === 0 ? "None is chosen." : null)}
        title={`Let go of ${count(chosen.size, "vertex", "vertices")}`}
        onClick={() => chooseFrame({ chosen: new Set() })}
      >
        Clear
      </Button>
    </div>
  );
}

/** How joints are closed, where that is asked for. */
export function ClosingSetup() {
  const { errors, closing, runs, double, choices } = useFrame();
  const first = choices?.errors.find(({ id }) => id !== "none")?.id ?? choices?.errors[0]?.id ?? null;
  const why = first === null ? "The errors of machines are not known yet." : null;
  return (
    <Part title="Closing of the joints">
      <div className="stack">
        <Checkbox
          checked={errors !== null}
          why={why}
          onChange={(checked) => chooseFrame({ errors: checked ? first : null })}
        >
          Bend the wires with errors, and close their joints
        </Checkbox>
        {errors !== null && (
          <>
            <Field label="Errors">
              {(ids) => (
                <Select
                  {...ids}
                  value={errors}
                  choices={(choices?.errors ?? []).map(({ id, name }) => ({ value: id, label: name }))}
                  onChoose={(id) => chooseFrame({ errors: id })}
                />
              )}
            </Field>
            <Field label="Wires drawn">
              {(ids) => (
                <NumberField
                  {...ids}
                  label="Wires drawn"
                  kind="whole"
                  value={runs}
                  min={1}
                  max={10_000}
                  onCommit={(value) => chooseFrame({ runs: value })}
                />
              )}
            </Field>
            <Faces />
          </>
        )}
        <Field label="Joints" stacked>
          {() => (
            <Segmented
              label="Joints"
              value={closing}
              choices={[
                { value: "aligned", label: "Pulled, then locked" },
                { value: "coupled", label: "Rigid" },
              ]}
              onChoose={(value) => chooseFrame({ closing: value })}
            />
          )}
        </Field>
        <Checkbox checked={double} onChange={(checked) => chooseFrame({ double: checked })}>
          Run wires along edges twice where there is no other way
        </Checkbox>
      </div>
    </Part>
  );
}
