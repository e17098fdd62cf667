import { useEffect, useState } from "react";
import type { DesignInput, LengthUnit } from "../../generated/requests";
import type { LookResponse } from "../../generated/responses";
import { platform } from "../../platform";
import { errorText } from "../../platform/error_text";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Checkbox, Select } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { count, roughly } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { Dialog } from "../../shared/layers/Dialog";
import { told } from "../../state/asking/problems";
import { useDesign } from "../../state/design/design";

import {
  addWireframe,
  baseName,
  isBegun,
  isDrawing,
  type Opening,
  openAs,
  type Use,
  useFiles,
} from "../../state/files/files";
import { asInput, CurveFields, cuttingFor } from "./CurveFields";

import { likeness } from "./likeness";
import { RunOrDesign } from "./RunOrDesign";

const UNITS: readonly { value: LengthUnit; label: string }[] = [
  { value: "mm", label: "Millimetres" },
  { value: "cm", label: "Centimetres" },
  { value: "m", label: "Metres" },
  { value: "inch", label: "Inches" },
];

const USES: readonly { use: Use; title: string; text: string }[] = [
  { use: "stencil", title: "Trace on it", text: "The surface becomes a stencil to draw the wire on." },
  { use: "edges", title: "Bend along its edges", text: "The edges of its faces become the wireframe." },
  { use: "both", title: "Both", text: "Its edges as the wireframe, its surface as the stencil." },
];

/** How a file is to be read, asked once: its unit, with the size that comes out, and what becomes of it. */
export function OpeningDialog() {
  const opening = useFiles((files) => files.opening);
  if (!opening) return null;
  const runs = opening.purpose === "design" && (opening.look.runs || opening.look.seen === "moves");
  return runs ? <RunOrDesign key={opening.path} opening={opening} /> : <Asking key={opening.path} opening={opening} />;
}

function Asking({ opening }: { readonly opening: Opening }) {
  const { path, purpose } = opening;
  const [look, setLook] = useState<LookResponse>(opening.look);
  /** What `look` was asked with; null before the first answer for the choices here. */
  const [seenFor, setSeenFor] = useState<string | null>(null);
  const [units, setUnits] = useState<LengthUnit>("mm");
  const [scale, setScale] = useState(1);
  const [layers, setLayers] = useState<readonly string[]>([]);
  const [cutting, setCutting] = useState(() => cuttingFor(opening.look));
  const [use, setUse] = useState<Use>("stencil");
  const [busy, setBusy] = useState(false);
  // What it was when the file was chosen: what is read into the design while the dialog closes changes no button.
  const [filled] = useState(() => isBegun(useDesign.getState()));
  const { length, bare } = useLengths();
  const surface = look.faces > 0 && look.seen !== "document";
  const drawing = isDrawing(opening.look.format);
  const close = () => useFiles.setState({ opening: null });

  const design: DesignInput = {
    input: { file: path },
    ...(opening.look.asks_units ? { units } : {}),
    ...(scale === 1 ? {} : { scale }),
    ...(drawing ? { ...asInput(cutting), layers: [...layers] } : {}),
  };
  const asked = JSON.stringify(design);
  const first = seenFor === null;
  useEffect(() => {
    if (seenFor === asked) return;
    let current = true;
    const timer = setTimeout(
      () => {
        void told(platform.ask("look", { design: JSON.parse(asked) as DesignInput })).then((seen) => {
          if (!current) return;
          if (seen) setLook(seen);
          if (seen || first) setSeenFor(asked);
        });
      },
      first ? 0 : 150,
    );
    return () => {
      current = false;
      clearTimeout(timer);
    };
  }, [asked, seenFor, first]);

  const size = look.size_mm;
  const like = size && likeness(Math.max(...size));
  const chosen: Use | null = purpose !== "design" && look.faces > 0 ? "stencil" : surface ? use : null;
  // What has no surface is a wireframe: beside the design that is open, or instead of it.
  const adds = filled && look.faces === 0 && look.edges > 0 && look.seen !== "document";
  const onlyAdds = adds && purpose !== "design";
  const submit = async (add: boolean) => {
    setBusy(true);
    try {
      await (add ? addWireframe(design) : openAs(design, chosen));
    } finally {
      setBusy(false);
    }
  };
  // It opens as large as it stays: with what is known once it was read as the fields say.
  if (first) return null;
  return (
    <Dialog
      title={`Open ${baseName(path)}`}
      onClose={close}
      actions={
        <>
          <Button onClick={close}>Cancel</Button>
          {adds && !onlyAdds && (
            <Button why={busy ? "Reading the file" : null} onClick={() => void submit(true)}>
              Add to this design
            </Button>
          )}
          <Button
            kind="primary"
            data-first
            why={busy ? "Reading the file" : null}
            onClick={() => void submit(onlyAdds)}
          >
            {onlyAdds || (chosen === "stencil" && filled) ? "Add to this design" : "Open"}
          </Button>
        </>
      }
    >
      {(!drawing || look.edges === 0) && (
        <p className="muted">
          {[
            look.faces > 0 && (look.faces === 1 ? "1 face" : `${roughly(look.faces)} faces`),
            look.edges > 0 && `${count(look.edges, "edge")}, ${count(look.vertices, "vertex", "vertices")}`,
          ]
            .filter(Boolean)
            .join(" · ") || "The file is empty."}
        </p>
      )}
      {opening.look.asks_units && (
        <Field label="Unit" hint="This format does not state its unit.">
          {(ids) => <Select {...ids} choices={UNITS} value={units} onChoose={setUnits} />}
        </Field>
      )}
      {opening.look.seen !== "document" && (
        <Field label="Scale">
          {({ id }) => (
            <NumberField
              id={id}
              kind="number"
              label="Scale"
              value={scale}
              positive
              min={1e-6}
              max={1e6}
              onCommit={setScale}
            />
          )}
        </Field>
      )}
      {size && (
        <p className="opening-size" role="status">
          <strong>
            {bare(size[0])} × {bare(size[1])} × {length(size[2])}
          </strong>
          {like && <span className="muted">, {like}</span>}
        </p>
      )}
      {drawing && (
        <>
          {opening.look.layers.length > 1 && (
            <fieldset className="uses">
              <legend>Layers</legend>
              <div className="layers">
                {opening.look.layers.map((name) => (
                  <Checkbox
                    key={name}
                    checked={layers.includes(name)}
                    onChange={(on) => setLayers(on ? [...layers, name] : layers.filter((other) => other !== name))}
                  >
                    {name}
                  </Checkbox>
                ))}
              </div>
              <p className="muted small">
                {layers.length === 0 ? "None chosen: all visible ones are read." : "Only these are read."}
              </p>
            </fieldset>
          )}
          <CurveFields cutting={cutting} look={look} pending={seenFor !== asked} onChange={setCutting} />
        </>
      )}
      {surface && purpose === "design" && (
        <fieldset className="uses">
          <legend className="muted">Use of the surface</legend>
          {USES.map(({ use: value, title, text }) => (
            <label key={value} className="use">
              <input type="radio" name="use" checked={use === value} onChange={() => setUse(value)} />
              <span>
                <strong>{title}</strong>
                <span className="muted">{text}</span>
              </span>
            </label>
          ))}
        </fieldset>
      )}
      {look.notes.length > 0 && (
        <ul className="muted small">
          {look.notes.map((note) => (
            <li key={note.code + note.message}>{errorText(note)}</li>
          ))}
        </ul>
      )}
    </Dialog>
  );
}
