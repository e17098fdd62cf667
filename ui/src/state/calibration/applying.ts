/** What a calibration has found, given to the design, and taken back. */

import { platform } from "../../platform";
import { type DesignStore, edit, useDesign } from "../design/design";
import { useFiles } from "../files/files";
import { profilesChanged, useMachines } from "../machine/machines";
import { readingsOf, useCalibration, working } from "./calibration";

type Applied = NonNullable<ReturnType<typeof useCalibration.getState>["applied"]>;

/** Writes profiles of what was found, and gives them to the design. `force`: profiles of these ids are replaced. */
export function applyCalibration(machine_id: string, material_id: string, force: boolean): Promise<boolean> {
  return working(async () => {
    const { sheet, shape } = useCalibration.getState();
    const { state } = useDesign.getState();
    if (!sheet) return;
    const before = {
      machine: state?.machine ?? sheet.machine,
      material: state?.material ?? sheet.material,
    };
    const result = await platform.ask("apply-calibration", {
      sheet: sheet.sheet,
      machine_id,
      material_id,
      force,
      ...(shape === "better" ? {} : { shape }),
    });
    profilesChanged(null);
    const applied = {
      result,
      before,
      replaced: force,
      profiles: useMachines.getState().changes,
      opened: useFiles.getState().opened,
      readings: readingsOf({ sheet, shape }),
      compared: null,
    };
    useCalibration.setState({ applied, reverted: null, versions: null });
    await edit({ edit: "machine", machine: result.machine, material: result.material });
    const machines: [string, string] = [sheet.machine, result.machine];
    const compared = await platform.ask("calibrate-compare", { machines, sheet: sheet.sheet });
    useCalibration.setState({ applied: { ...applied, compared } });
  });
}

/** Whether the design that was given it has it still. */
function isTaken({ result, opened }: Applied, { state }: Pick<DesignStore, "state">): boolean {
  const isSame = opened === useFiles.getState().opened;
  return isSame && state?.machine === result.machine && state.material === result.material;
}

/** Whether the profiles that it has replaced can be as before: what was changed since would go instead. */
const isLastChange = ({ replaced, profiles }: Applied): boolean =>
  replaced && profiles === useMachines.getState().changes;

/** Why nothing can be taken back; null where something can. */
export function useWhyNotBack(): string | null {
  const { applied, reverted } = useCalibration();
  const state = useDesign((design) => design.state);
  useMachines(({ changes }) => changes);
  useFiles(({ opened }) => opened);
  if (!applied || reverted) return "Nothing is applied.";
  return isTaken(applied, { state }) || isLastChange(applied) ? null : "The design has another machine or wire by now.";
}

/** Whether what was applied is what the readings tell now. */
export function useIsOfReadings(): boolean {
  const calibration = useCalibration();
  return calibration.applied?.readings === readingsOf(calibration);
}

/** The design has its machine and its wire of before; profiles that were replaced are as before. */
export function revertCalibration(): Promise<boolean> {
  return working(async () => {
    const { applied } = useCalibration.getState();
    if (!applied) return;
    const { result, before } = applied;
    const done = { design: isTaken(applied, useDesign.getState()), profiles: isLastChange(applied) };
    if (done.design) await edit({ edit: "machine", machine: before.machine, material: before.material });
    try {
      // The machine first: it names the wire. One of both may be new.
      for (const [kind, id] of [
        ["machine", result.machine],
        ["material", result.material],
      ] as const) {
        if (!done.profiles) break;
        const { has_last_change } = await platform.ask("profile-view", { kind, id });
        if (has_last_change) await platform.ask("revert-profile", { kind, id, keys: [] });
      }
    } finally {
      // The machine may be as before where the wire cannot be, which can be tried again.
      profilesChanged(null);
      const { changes } = useMachines.getState();
      if (done.profiles) useCalibration.setState({ applied: { ...applied, profiles: changes } });
    }
    useCalibration.setState({ reverted: done, versions: null });
  });
}
