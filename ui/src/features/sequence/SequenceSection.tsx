import { useEffect, useState } from "react";
import type { DrawnSequence } from "../../generated/responses";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Bar, Checkbox, Segmented, Select } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { number, sentence, time } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { Confirm } from "../../shared/layers/Confirm";
import { Line } from "../../shared/lists/Line";
import { useWork } from "../../state/asking/work";
import { useDesign } from "../../state/design/design";
import { needFrameChoices, useFrame } from "../../state/frame/frame";
import { pickSequence, saveSequence, whyNotSaved } from "../../state/sequence/files";
import {
  cancelSequence,
  chooseBuilder,
  chooseEpsilon,
  chooseGroups,
  findSequence,
  showLayers,
  shownSequence,
  slideTo,
  takeBackMoves,
  underWay,
  useSequence,
  useSequenceStale,
} from "../../state/sequence/sequence";
import { Finding } from "../frame/Results";
import { cssOf, layerColour } from "../frame/ramp";
import { displacement } from "../frame/words";
import { Notes } from "../panel/Notes";
import { Part, Section } from "../panel/Section";
import { Curve } from "./Curve";
import { Steps } from "./Steps";
import { phraseOf, STRATEGIES } from "./words";
import "../frame/frame.css";
import "./sequence.css";

/** What the chosen machine builds with; null: the material of the design. */
function materialNow(): string | null {
  const { machine } = useSequence.getState();
  const { choices } = useFrame.getState();
  return choices?.strut_builders.find(({ id }) => id === machine)?.default_material ?? null;
}

/** What takes the place of an order that was changed by hand: the sequence of a file, or without one that of a search. */
interface Replacing {
  readonly file: string | null;
}

/** The order in which a machine builds the struts. */
export function SequenceSection() {
  const [replacing, setReplacing] = useState<Replacing | null>(null);
  const { found, changed, asking, checking, problem, tried } = useSequence();
  const stale = useSequenceStale();
  const empty = useDesign((design) => design.edges.size === 0);
  const drawn = shownSequence({ found, changed });
  const failed = tried === "check" ? "not checked" : "not found";
  const phrase = asking
    ? "looking for a sequence…"
    : checking
      ? "checking the sequence…"
      : drawn && stale
        ? "changed since"
        : drawn
          ? phraseOf(drawn)
          : problem
            ? failed
            : "not looked for yet";
  const tone = asking
    ? null
    : drawn
      ? stale
        ? "warning"
        : drawn.sequence.feasible
          ? "fine"
          : "error"
      : problem
        ? "error"
        : null;
  const put = (by: Replacing) => {
    setReplacing(null);
    void findSequence(materialNow(), by.file);
  };
  const ask = (by: Replacing) => (useSequence.getState().changed ? setReplacing(by) : put(by));
  return (
    <>
      <Section id="sequence" title="Sequence" phrase={phrase} tone={tone}>
        {empty ? (
          <p className="muted">Draw or open a design. Its edges are then struts that a machine builds one by one.</p>
        ) : (
          <div className="stack">
            <Setup onAsk={ask} />
            {problem && (
              <ul>
                <Line tone="error" what={`The sequence was ${failed}`} sub={problem} />
              </ul>
            )}
            {drawn && <Found drawn={drawn} />}
          </div>
        )}
      </Section>
      {replacing && (
        <Confirm
          title="Replace your order?"
          label={replacing.file === null ? "Replace and find" : "Replace and open"}
          onConfirm={() => put(replacing)}
          onClose={() => setReplacing(null)}
        >
          <p>
            You changed the order by hand. The order {replacing.file === null ? "that is found" : "of the file"}{" "}
            replaces it. It cannot be undone.
          </p>
        </Confirm>
      )}
    </>
  );
}

function Setup({ onAsk }: { readonly onAsk: (by: Replacing) => void }) {
  const sequence = useSequence();
  const { machine, epsilon, groupBy, asking, cancelled, checking, saving } = sequence;
  const wires = useDesign(({ state }) => state?.walks.length ?? 0);
  const builders = useFrame(({ choices }) => choices?.strut_builders ?? null);
  const stale = useSequenceStale();
  const supports = useDesign(({ vertices }) => [...vertices.values()].some(({ support }) => support));
  const work = useWork(({ works }) => works.get("sequence"));
  useEffect(needFrameChoices, []);
  useEffect(() => {
    const [first] = builders ?? [];
    if (machine === null && first) chooseBuilder(first.id);
  }, [builders, machine]);
  const builder = builders?.find(({ id }) => id === machine);
  const why = builder ? underWay(sequence) : "The machines that build struts are not known yet.";
  const open = async () => {
    const file = await pickSequence();
    if (file !== null) onAsk({ file });
  };
  return (
    <>
      <Field label="Machine">
        {(ids) => (
          <Select
            {...ids}
            value={machine ?? ""}
            choices={(builders ?? []).map(({ id, name }) => ({ value: id, label: name }))}
            onChoose={chooseBuilder}
          />
        )}
      </Field>
      <div className="field">
        <span className="field-name">Struts</span>
        <span>{builder?.default_material ?? "of the design's material"}</span>
      </div>
      <Field label="Placed">
        {() => (
          <Segmented
            label="Placed at once"
            value={groupBy}
            choices={[
              { value: "edge", label: "A strut" },
              {
                value: "wire",
                label: wires > 0 ? `A wire (${wires})` : "A wire",
                why: wires > 0 ? null : "Choose the walks of the wires first: which edges are one wire is not known.",
              },
            ]}
            onChoose={chooseGroups}
          />
        )}
      </Field>
      <Field label="Sag, at most">
        {(ids) => (
          <div className="row">
            <NumberField
              {...ids}
              label="Sag, at most"
              value={epsilon}
              positive
              min={1e-6}
              max={1e6}
              placeholder="automatic"
              onCommit={chooseEpsilon}
            />
            {epsilon !== null && (
              <Button
                kind="quiet"
                small
                icon="close"
                aria-label="What the head still meets"
                title="What the head still meets"
                onClick={() => chooseEpsilon(null)}
              />
            )}
          </div>
        )}
      </Field>
      <div className="row">
        <span className="grow muted small" role="status">
          {asking
            ? work && work.of > 0
              ? `${number(work.done, 0)} of ${number(work.of, 0)} struts in order`
              : `${sentence(work?.stage || "reading")}…`
            : checking
              ? "Checking the sequence…"
              : saving
                ? "Saving the sequence…"
                : cancelled
                  ? "Cancelled."
                  : stale
                    ? "Something was changed since."
                    : supports
                      ? ""
                      : "Mark the vertices on the ground as supports, under Edit."}
        </span>
        {asking ? (
          <Button className="frame-go" onClick={cancelSequence}>
            Cancel
          </Button>
        ) : (
          <>
            <Button why={why} onClick={() => void open()}>
              Open…
            </Button>
            <Button kind="primary" className="frame-go" why={why} onClick={() => onAsk({ file: null })}>
              Find
            </Button>
          </>
        )}
      </div>
      <div className="frame-bar">
        {(asking || checking || saving) && (
          <Bar
            done={asking ? (work?.done ?? 0) : 0}
            of={asking ? (work?.of ?? 0) : 0}
            label={asking ? "Looking for a sequence" : checking ? "Checking the sequence" : "Saving the sequence"}
          />
        )}
      </div>
    </>
  );
}

function Found({ drawn }: { readonly drawn: DrawnSequence }) {
  const { at, found, changed, layers } = useSequence();
  const { length, unit } = useLengths();
  // What the save asks for is looked at with it.
  useSequenceStale();
  const { sequence } = drawn;
  const steps = sequence.steps.length;
  const all = found?.sequence.layers ?? [];
  return (
    <>
      {sequence.diagnostics.length > 0 && (
        <ul className="build-findings">
          {sequence.diagnostics.slice(0, MAX_FINDINGS).map((report) => (
            <Finding key={`${report.code} ${report.message}`} report={report} />
          ))}
        </ul>
      )}
      {sequence.diagnostics.length > MAX_FINDINGS && (
        <p className="muted small">And {number(sequence.diagnostics.length - MAX_FINDINGS, 0)} more.</p>
      )}
      <Notes notes={sequence.notes} />
      {steps > 0 && (
        <>
          {changed && (
            <ul>
              <Line
                tone={changed.sequence.feasible ? "fine" : "error"}
                what={changed.sequence.feasible ? "Your order can be built" : "Your order cannot be built"}
                action={
                  <Button kind="link" onClick={takeBackMoves}>
                    Take back
                  </Button>
                }
              />
            </ul>
          )}
          <table className="figures" aria-label="Sequence">
            <tbody>
              <tr>
                <td>Largest sag</td>
                <td>
                  {sequence.max_displacement_mm == null
                    ? "does not stand"
                    : `${displacement(sequence.max_displacement_mm, unit)} of ${displacement(sequence.epsilon_mm, unit)}`}
                </td>
              </tr>
              <tr>
                <td>Share a vertex with the step before</td>
                <td>
                  {sequence.sharing} of {steps}
                </td>
              </tr>
              {sequence.min_free_directions != null && (
                <tr>
                  <td>Fewest free directions</td>
                  <td>
                    {sequence.min_free_directions} of {drawn.directions.length}
                  </td>
                </tr>
              )}
              {sequence.time_s != null && (
                <tr>
                  <td>Time</td>
                  <td>{time(sequence.time_s)}</td>
                </tr>
              )}
              {sequence.travel_mm != null && (
                <tr>
                  <td>Travel between struts</td>
                  <td>{length(sequence.travel_mm)}</td>
                </tr>
              )}
            </tbody>
          </table>
          {sequence.strategy && <p className="muted small">{sentence(STRATEGIES[sequence.strategy])}.</p>}
          <Curve drawn={drawn} at={at} />
          <Checkbox
            checked={layers}
            why={all.length > 0 ? null : "There are no layers."}
            onChange={(checked) => {
              showLayers(checked);
              slideTo(at);
            }}
          >
            Colours of the layers ({number(all.length, 0)})
          </Checkbox>
          {layers && all.length > 0 && (
            <div className="layer-key small muted">
              {all.map((edges, layer) => (
                // biome-ignore lint/suspicious/noArrayIndexKey: a layer is known by its place
                <span key={layer}>
                  <i style={{ background: cssOf(layerColour(layer)) }} />
                  {layer + 1}: {edges.length}
                </span>
              ))}
            </div>
          )}
          <Part title="Steps">
            <Steps drawn={drawn} />
          </Part>
          <div className="row end">
            <Button why={whyNotSaved()} onClick={() => void saveSequence()}>
              Save sequence…
            </Button>
          </div>
        </>
      )}
    </>
  );
}

/** More findings than these are no help. */
const MAX_FINDINGS = 6;
