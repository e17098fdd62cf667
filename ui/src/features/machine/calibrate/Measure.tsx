import { type KeyboardEvent, useEffect, useRef, useState } from "react";
import type { CalibrationRow, CalibrationSheet } from "../../../generated/responses";
import { platform } from "../../../platform";
import { Button } from "../../../shared/controls/Button";
import { sentence } from "../../../shared/figures/format";
import { Scrolls } from "../../../shared/lists/Scrolls";
import { told } from "../../../state/asking/problems";
import { addPinTable, enterBent, enterReading, useCalibration } from "../../../state/calibration/calibration";
import { baseName } from "../../../state/files/files";
import { useSheetName } from "./sheet_name";
import { leftOut, parseReading, shownReading, unbentPhrase, WHAT, wanted } from "./words";

const TABLES = { name: "Tables", extensions: ["csv", "txt"] } as const;

/** The sheet as a table: a reading a cell, empty where there is none. */
export function Measure() {
  const sheet = useCalibration((calibration) => calibration.sheet);
  return sheet && <Sheet sheet={sheet} />;
}

function Sheet({ sheet }: { readonly sheet: CalibrationSheet }) {
  const { report, gap, busy, unbent } = useCalibration();
  const toBend = unbentPhrase(unbent.map(baseName));
  const of = useSheetName(sheet);
  const [more, setMore] = useState(0);
  const columns = Math.max(1, ...sheet.rows.map(({ readings }) => readings.length)) + more;
  const newest = useRef<HTMLTableCellElement>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another column is the newest
  useEffect(() => {
    // A narrow window has no room for all: what was measured last is what a person looks at.
    newest.current?.scrollIntoView({ block: "nearest", inline: "end" });
  }, [columns]);
  const pinTable = async () => {
    const picked = await told(platform.pickFile([TABLES]));
    if (picked) await addPinTable(picked);
  };
  return (
    <>
      <p className="ellipsis" title={sheet.sheet}>
        Readings of {of}
      </p>
      <div className="row wrap">
        <p className="muted small grow">
          {Object.values(WHAT)
            .slice(0, 3)
            .map(({ name, how }) => `${sentence(name)}: ${how}`)
            .join(" ")}
        </p>
        <Button small icon="plus" onClick={() => setMore(more + 1)}>
          Column
        </Button>
        <Button
          small
          why={
            sheet.jobs.length === 0
              ? "The jobs of the coupons are not beside this sheet."
              : busy
                ? "Wait until this is done."
                : null
          }
          title="What the simulated machine has bent of these jobs"
          onClick={() => void enterBent()}
        >
          Take simulated runs
        </Button>
        <Button small title="A table of pin angle and springback angle" onClick={() => void pinTable()}>
          Add pin table…
        </Button>
      </div>
      <Scrolls className="calibrate-table" label="Readings">
        <table>
          <thead>
            <tr>
              <th scope="col">Coupon</th>
              <th scope="col">Measure</th>
              <th scope="col" className="figure">
                Wanted
              </th>
              {Array.from({ length: columns }, (_, at) => (
                // biome-ignore lint/suspicious/noArrayIndexKey: a column has no other name
                <th key={at} ref={at === columns - 1 ? newest : null} scope="col" className="figure">
                  Reading {at + 1}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {sheet.rows.map((row, index) => (
              <tr key={`${row.line} ${row.coupon} ${row.row}`} className={row.row === 1 ? "first" : undefined}>
                <th scope="row">{row.row === 1 ? row.coupon : ""}</th>
                <td title={sentence(WHAT[row.what]?.how ?? "")}>{WHAT[row.what]?.name ?? row.what}</td>
                <td className="figure muted">{wanted(row)}</td>
                {Array.from({ length: columns }, (_, at) => (
                  // biome-ignore lint/suspicious/noArrayIndexKey: a column has no other name
                  <td key={at} className="reading">
                    <Reading row={row} index={index} at={at} wrong={leftOut(report, row, at)} />
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </Scrolls>
      <div className="calibrate-notes" aria-live="polite">
        {toBend && <p>{toBend}</p>}
        {gap && <p className="value-refused">{gap}</p>}
        {report?.left_out.map(({ line, reading, coupon, message }) => (
          <p key={`${line} ${reading}`} className="calibrate-left">
            <strong>
              {coupon}, reading {reading}:
            </strong>{" "}
            {message}
          </p>
        ))}
        {!gap && report && report.left_out.length === 0 && <p className="muted">Every reading fits the others.</p>}
        {!gap && !report && <p className="muted">Type what you measure. A cell may stay empty.</p>}
      </div>
    </>
  );
}

/** A cell. Taken with Enter, which goes down, or by leaving it. */
function Reading({
  row,
  index,
  at,
  wrong,
}: {
  readonly row: CalibrationRow;
  readonly index: number;
  readonly at: number;
  /** Why it is left out of the fit. */
  readonly wrong: string | null;
}) {
  const reading = row.readings[at] ?? null;
  const [typed, setTyped] = useState<string | null>(null);
  const read = typed === null ? reading : parseReading(typed, row.unit);
  const commit = () => {
    if (typed !== null && read !== undefined && read !== reading) void enterReading(row, at, read);
    if (read !== undefined) setTyped(null);
  };
  const keys = (event: KeyboardEvent<HTMLInputElement>) => {
    const down = event.key === "ArrowDown" || event.key === "Enter" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    if (event.key === "Escape" && typed !== null) {
      event.preventDefault();
      event.stopPropagation();
      setTyped(null);
    } else if (down !== 0) {
      event.preventDefault();
      commit();
      const next = event.currentTarget.closest("table")?.querySelector(`[data-cell="${index + down} ${at}"]`);
      if (next instanceof HTMLInputElement) next.focus();
    }
  };
  const number = read === undefined;
  return (
    <span className={number ? "reading-cell wrong" : wrong ? "reading-cell left" : "reading-cell"}>
      <input
        type="text"
        inputMode="decimal"
        autoComplete="off"
        data-cell={`${index} ${at}`}
        aria-label={`${row.coupon}, row ${row.row}, reading ${at + 1}`}
        aria-invalid={number || Boolean(wrong) || undefined}
        title={number ? "Expected a number, or nothing" : (wrong ?? undefined)}
        value={typed ?? shownReading(reading)}
        onFocus={(event) => event.currentTarget.select()}
        onChange={(event) => setTyped(event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={keys}
      />
      <span className="muted" aria-hidden="true">
        {row.unit === "deg" ? "°" : "mm"}
      </span>
    </span>
  );
}
