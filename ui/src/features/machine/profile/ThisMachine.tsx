import { useEffect, useState } from "react";
import type { MachineViewResponse } from "../../../generated/responses";
import { errorText } from "../../../platform/error_text";
import { Button } from "../../../shared/controls/Button";
import { Fold } from "../../../shared/controls/Fold";
import { number } from "../../../shared/figures/format";
import { useLengths } from "../../../shared/figures/unit";
import { Line } from "../../../shared/lists/Line";
import { openCalibration } from "../../../state/calibration/calibration";
import { useMachines, viewOf } from "../../../state/machine/machines";
import { openProfile } from "../../../state/machine/profile";
import { besideBend, leastLength } from "../choosing/fit";
import { range } from "../choosing/MachineList";
import { MachineSettings } from "../settings/MachineSettings";
import { CopyProfile } from "./CopyProfile";
import { ExplainDialog } from "./ExplainDialog";

/** What is known of the machine of the design, and its settings. */
export function ThisMachine({ id }: { readonly id: string }) {
  const view = useMachines((store) => store.views.get(id) ?? null);
  const [problem, setProblem] = useState<string | null>(null);
  const [dialog, setDialog] = useState<"explain" | "copy" | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: what was known of it is dropped when profiles change
  useEffect(() => {
    setProblem(null);
    viewOf(id).catch((error: unknown) => setProblem(error instanceof Error ? error.message : String(error)));
  }, [id, view]);
  if (!view) {
    return problem ? (
      <ul>
        <Line tone="error" what="The machine does not answer" sub={problem} />
      </ul>
    ) : (
      <p className="muted">Loading the driver…</p>
    );
  }
  return (
    <div className="stack">
      {view.driver_problem && (
        <ul>
          <Line tone="error" what={`Its driver “${view.driver}” cannot be used`} sub={errorText(view.driver_problem)} />
        </ul>
      )}
      <p>{view.description}</p>
      {view.head_measured === false && (
        <ul>
          <Line
            tone="info"
            what="The bend head of your machine was not measured"
            sub="Its dimensions are those of the profile, and your bends can be some degrees off. Calibrate before the first wire: bending, cutting and reading the coupons takes about an hour."
          />
        </ul>
      )}
      <Figures view={view} />
      <div className="row wrap">
        <Button onClick={() => void openProfile("machine", view.id)}>
          {view.shipped ? "Values…" : "Edit values…"}
        </Button>
        <Button onClick={openCalibration}>Calibrate…</Button>
        <Button onClick={() => setDialog("explain")}>Explain…</Button>
        <Button
          icon="copy"
          onClick={() => setDialog(dialog === "copy" ? null : "copy")}
          aria-expanded={dialog === "copy"}
        >
          Copy to my profiles…
        </Button>
      </div>
      {dialog === "copy" && (
        <CopyProfile kind="machine" from={view.id} fromName={view.name} onDone={() => setDialog(null)} />
      )}
      {dialog === "explain" && <ExplainDialog id={view.id} name={view.name} onClose={() => setDialog(null)} />}
      <Fold title="Settings" phrase={view.shipped ? "as shipped" : "yours"}>
        <MachineSettings key={view.id} view={view} />
      </Fold>
    </div>
  );
}

function Figures({ view }: { readonly view: MachineViewResponse }) {
  const { length, long, bare, name, unit } = useLengths();
  const [feed, rotate, bend] = view.rates;
  const rows: readonly (readonly [string, string])[] = [
    ["Bend", range(view.bend_deg)],
    ["Rotation", range(view.rotation_deg)],
    ["Shortest edge", leastLength(view.min_edge_mm, unit) + besideBend(view, unit)],
    ["Shortest feed", length(view.min_feed_mm)],
    ["Wire", `${bare(view.diameter_mm[0])} to ${length(view.diameter_mm[1])}`],
    ["Stock", view.max_stock_mm === null ? "any length" : `at most ${long(view.max_stock_mm)}`],
    ["Speeds", `${bare(feed)} ${name}/s · ${number(rotate)}°/s · ${number(bend)}°/s`],
    ["Profile", view.file],
  ];
  return (
    <dl className="pairs">
      {rows.map(([title, value]) => (
        <div key={title}>
          <dt>{title}</dt>
          <dd className="selectable">{value}</dd>
        </div>
      ))}
    </dl>
  );
}
