import { Button } from "../../../shared/controls/Button";
import { count, time } from "../../../shared/figures/format";
import { useLengths } from "../../../shared/figures/unit";
import { Line } from "../../../shared/lists/Line";
import { openPath, pickRunFile } from "../../../state/files/files";
import { useMachines } from "../../../state/machine/machines";
import type { MachineState } from "../../../state/machine/operator";
import { isBending, order, useRun } from "../../../state/machine/run";
import { closeRunFile, openRunFile, useRunFile } from "../../../state/program/run_file";
import { Part } from "../../panel/Section";
import { buttons } from "../buttons";
import { useProspect } from "../prospect";
import { findingsOf, HOW, kindPhrase } from "./phrases";

/** What is run: the design, or a file with a job, a program or recorded moves. */
export function ToRun({ state }: { readonly state: MachineState | null }) {
  const file = useRunFile((run) => run.file);
  const machines = useMachines((store) => store.machines);
  const { length, long } = useLengths();
  const all = buttons(state, useProspect());
  const under = useRun(isBending);
  if (!file) {
    return (
      <Part title="To run">
        <div className="row">
          <span className="grow muted">The open design</span>
          <Button small onClick={() => void pickRunFile()}>
            Run a file…
          </Button>
        </div>
      </Part>
    );
  }
  const { name, kind, wires, moves, path } = file;
  const machine = machines?.find(({ id }) => id === file.machine)?.name ?? file.machine;
  const sum = (of: (wire: (typeof wires)[number]) => number) => wires.reduce((total, wire) => total + of(wire), 0);
  const figures = [
    kind === "moves"
      ? count(moves, "move")
      : count(
          sum(({ steps }) => steps),
          "step",
        ),
    `${length(sum(({ length_mm }) => length_mm))} fed`,
    ...(kind === "moves" ? [] : [`stock ${long(sum(({ stock_mm }) => stock_mm))}`, time(sum(({ time_s }) => time_s))]),
  ];
  return (
    <Part title="To run">
      <fieldset className="run-file stack" aria-label="File to run">
        <div className="run-file-name">
          <strong className="ellipsis" title={path ?? undefined}>
            {name}
          </strong>
          <span className="muted small ellipsis">{kindPhrase(kind, machine)}</span>
        </div>
        <p className="muted small">{figures.join(" · ")}</p>
        <ul>
          <Line tone="info" what={HOW[kind].what} sub={HOW[kind].sub} />
          {findingsOf(file).map(({ tone, what, sub }) => (
            <Line key={what} tone={tone} what={what} sub={sub} />
          ))}
        </ul>
        <div className="row end wrap">
          {path !== null && kind !== "job" && (
            <Button small onClick={() => void openPath(path, "design", "design")}>
              Make it a design…
            </Button>
          )}
          {path !== null && (
            <Button small why={under ? "A wire is being bent." : null} onClick={() => void openRunFile(path)}>
              Read again
            </Button>
          )}
          <Button small why={under ? "A wire is being bent." : null} onClick={() => void closeRunFile()}>
            Close the file
          </Button>
          {kind === "moves" && (
            <Button
              small
              kind="primary"
              why={path === null ? "It is in no file." : all.replay}
              onClick={() => void order({ order: "replay", file: path, other_machine: false })}
            >
              Replay…
            </Button>
          )}
        </div>
      </fieldset>
    </Part>
  );
}
