import { useRef, useState } from "react";
import { platform } from "../../../platform";
import { Button } from "../../../shared/controls/Button";
import { Field } from "../../../shared/controls/Field";
import { Select, TextInput } from "../../../shared/controls/inputs";
import { NumberField } from "../../../shared/controls/NumberField";
import { count, time } from "../../../shared/figures/format";
import { useLengths } from "../../../shared/figures/unit";
import { Confirm } from "../../../shared/layers/Confirm";
import { Line } from "../../../shared/lists/Line";
import { told } from "../../../state/asking/problems";
import {
  type CouponRequest,
  closeCalibration,
  makeCoupons,
  openSheet,
  useCalibration,
} from "../../../state/calibration/calibration";
import { useDesign } from "../../../state/design/design";
import { baseName, runFile } from "../../../state/files/files";
import { useMachines } from "../../../state/machine/machines";
import { type SheetOf, useSheetName } from "./sheet_name";
import { lostReadings, parseAngles, usualAngles } from "./words";

const SHEETS = { name: "Sheets", extensions: ["csv"] } as const;
/** It is a folder that is named: there is no ending. */
const FOLDER = { name: "Folders", extensions: [] } as const;

/** The jobs of the coupons, each to be run. */
function Jobs({ jobs }: { readonly jobs: readonly string[] }) {
  const run = (job: string) => {
    closeCalibration();
    void runFile(job);
  };
  return (
    <ul className="stack">
      {jobs.map((job) => (
        <li key={job} className="row">
          <span className="selectable calibrate-file grow" title={job}>
            {baseName(job)}
          </span>
          <Button
            small
            icon="play"
            title="Opens Run with this job. Nothing moves before you arm a wire and start it."
            aria-label={`Run ${baseName(job)}`}
            onClick={() => run(job)}
          >
            Run…
          </Button>
        </li>
      ))}
    </ul>
  );
}

/** Whether coupons are as they would be made. */
const isSame = (made: CouponRequest, chosen: Omit<CouponRequest, "folder">): boolean =>
  (["machine", "material", "repeats", "paper"] as const).every((key) => made[key] === chosen[key]) &&
  String(made.angles_deg) === String(chosen.angles_deg);

/** What coupons are for. `other`: that they are not for what is chosen, where that is so; Next goes on with their sheet all the same. */
function Of({ sheet, other }: { readonly sheet: SheetOf; readonly other: string | null }) {
  const what = useSheetName(sheet);
  if (other === null) return <p className="muted small">For {what}.</p>;
  return (
    <ul>
      <Line
        tone="warning"
        what={other}
        sub={`These are for ${what}, and Next goes on with their sheet. Make coupons anew for what is chosen.`}
      />
    </ul>
  );
}

/** What is bent to be measured: jobs, and a sheet for the readings. */
export function Coupons() {
  const { made, madeFor, occupied, sheet, busy } = useCalibration();
  const { machines, materials } = useMachines();
  const state = useDesign((design) => design.state);
  const [machine, setMachine] = useState(madeFor?.machine ?? state?.machine ?? "");
  const [material, setMaterial] = useState(madeFor?.material ?? state?.material ?? "");
  const [angles, setAngles] = useState(madeFor?.angles_deg.join(", ") ?? "");
  const [repeats, setRepeats] = useState(madeFor?.repeats ?? 2);
  const [paper, setPaper] = useState(madeFor?.paper ?? "a4");
  const [replacing, setReplacing] = useState(false);
  const makes = useRef<HTMLButtonElement>(null);
  const offer = useRef<HTMLDivElement>(null);
  const { long } = useLengths();
  const bends = machines?.find(({ id }) => id === machine)?.bend_deg ?? null;
  const ladder = parseAngles(angles);
  const why = busy
    ? "Wait until this is done."
    : machine === "" || material === ""
      ? "Choose a machine and a wire."
      : ladder === null
        ? "Correct the angles."
        : null;
  const chosen = { machine, material, angles_deg: ladder ?? [], repeats, paper };
  const changed =
    madeFor && ladder && isSame(madeFor, chosen) ? null : "The choices were changed since these coupons were made";
  const another =
    sheet?.machine === machine && sheet.material === material
      ? null
      : "Another machine or wire is chosen than that of the sheet";
  const make = async () => {
    const folder = await told(platform.pickSave("calibration", FOLDER));
    if (folder) await makeCoupons({ ...chosen, folder }, false);
  };
  const replace = async () => {
    setReplacing(false);
    if (!occupied || !(await makeCoupons({ ...chosen, folder: occupied.folder }, true))) return;
    // The button that had the focus goes with what it offered.
    const { activeElement: focused, body } = document;
    if (!focused || focused === body || offer.current?.contains(focused)) makes.current?.focus();
  };
  const lost = occupied && lostReadings(occupied.readings);
  // Readings may have come into the sheet since it was looked at.
  const askToReplace = async () => {
    if (!occupied) return;
    if (!(await makeCoupons({ ...chosen, folder: occupied.folder }, false))) return;
    const now = useCalibration.getState().occupied;
    if (now && lostReadings(now.readings)) setReplacing(true);
    else if (now) await replace();
  };
  const open = async () => {
    const picked = await told(platform.pickFile([SHEETS]));
    if (picked) await openSheet(picked, "measure");
  };
  return (
    <div className="calibrate-columns">
      <div className="stack">
        <p>
          Short wires with one or two bends each are bent and measured. The readings tell how much your wire springs
          back, where the peg goes, how much wire a bend takes, and how well each of these is known.
        </p>
        <Field label="Machine">
          {(ids) => (
            <Select
              {...ids}
              value={machine}
              choices={(machines ?? []).map(({ id, name }) => ({ value: id, label: name }))}
              onChoose={setMachine}
            />
          )}
        </Field>
        <Field label="Wire">
          {(ids) => (
            <Select
              {...ids}
              value={material}
              choices={(materials ?? []).map(({ id, name }) => ({ value: id, label: name }))}
              onChoose={setMaterial}
            />
          )}
        </Field>
        <Field
          label="Angles"
          hint={`Degrees, each to both sides. Empty: ${usualAngles(bends)}.`}
          error={ladder === null ? "Write angles up to 180°, such as 20, 45, 90." : null}
        >
          {(ids) => (
            <TextInput
              {...ids}
              value={angles}
              placeholder="such as 20, 45, 90"
              onChange={(event) => setAngles(event.currentTarget.value)}
            />
          )}
        </Field>
        <Field label="Repeats" hint="How often each coupon is bent: two show how far bends scatter.">
          {(ids) => (
            <NumberField {...ids} label="Repeats" kind="whole" min={1} max={20} value={repeats} onCommit={setRepeats} />
          )}
        </Field>
        <Field label="Paper" hint="Of the sheet to print.">
          {(ids) => (
            <Select
              {...ids}
              value={paper}
              choices={[
                { value: "a4", label: "A4" },
                { value: "letter", label: "US Letter" },
              ]}
              onChoose={setPaper}
            />
          )}
        </Field>
        <div className="row wrap">
          <Button ref={makes} kind="primary" icon="folder" why={why} onClick={() => void make()}>
            Make coupons in a folder…
          </Button>
          <Button icon="file" onClick={() => void open()}>
            Open a sheet…
          </Button>
        </div>
        <div ref={offer} role="alert">
          {occupied !== null && (
            <ul>
              <Line
                tone="error"
                what={`There are coupons in ${baseName(occupied.folder)} already`}
                sub={`Choose another folder, or replace them. ${lost ? `Replacing deletes ${lost}.` : "Their sheet has no readings."}`}
                action={
                  <Button kind="link" why={why} onClick={() => void askToReplace()}>
                    {lost ? "Replace…" : "Replace"}
                  </Button>
                }
              />
            </ul>
          )}
        </div>
        {replacing && occupied && lost && (
          <Confirm
            title={`Replace the coupons in ${baseName(occupied.folder)}?`}
            label="Replace and delete"
            onConfirm={() => void replace()}
            onClose={() => setReplacing(false)}
          >
            <p>This deletes {lost}. It cannot be undone.</p>
          </Confirm>
        )}
      </div>
      <div className="stack calibrate-made" aria-live="polite">
        {made ? (
          <>
            <h3>Bend these</h3>
            <Of sheet={made} other={changed} />
            <p>
              {count(made.coupons, "coupon")}, each {count(made.repeats, "time")}: {long(made.wire_mm)} of wire, about{" "}
              {time(made.seconds)} on the machine.
            </p>
            <Jobs jobs={made.jobs} />
            <p className="muted small">
              Bend the wires of each job as often as there are columns for readings. Cut the wire behind each coupon and
              write its name on it. Then come back to this sheet:
            </p>
            <p className="selectable calibrate-file">{made.sheet}</p>
            <p className="muted small">
              To print in true size: a protractor for the bends, and boxes for the readings.
            </p>
            <p className="selectable calibrate-file">{made.printed}</p>
          </>
        ) : sheet ? (
          <>
            <h3>Open sheet</h3>
            <p className="selectable calibrate-file">{sheet.sheet}</p>
            <Of sheet={sheet} other={another} />
            {sheet.jobs.length > 0 && <Jobs jobs={sheet.jobs} />}
          </>
        ) : (
          <p className="muted">The files that are made are listed here.</p>
        )}
      </div>
    </div>
  );
}
