/** The window closes: what is asked before, and what ends with it. */

import { create } from "zustand";
import { platform } from "../../platform";
import { told } from "../asking/problems";
import type { Phase } from "../machine/operator";
import { useRun } from "../machine/run";
import { closeDesign, mayLeave } from "./files";

interface ClosingStore {
  /** The machine is at work: whether it is stopped and the window closed. */
  readonly asked: { readonly phase: Phase; readonly answer: (yes: boolean) => void } | null;
}

export const useClosing = create<ClosingStore>()(() => ({ asked: null }));

/** True when the machine stands, or has been stopped because the person says so. */
async function mayLeaveMachine(): Promise<boolean> {
  const { state } = useRun.getState();
  if (!state?.may_move) return true;
  const { phase } = state;
  // One question at a time: the one before is answered by staying.
  useClosing.getState().asked?.answer(false);
  let mine: ClosingStore["asked"] = null;
  const yes = await new Promise<boolean>((answer) => {
    mine = { phase, answer };
    useClosing.setState({ asked: mine });
  });
  if (useClosing.getState().asked === mine) useClosing.setState({ asked: null });
  if (!yes) return false;
  try {
    await platform.stop();
    return true;
  } catch (error) {
    // A user who cannot stop it from here has to see that it continues.
    await told(Promise.reject(error));
    return false;
  }
}

/** Whether the window may close. When it may, the machine stands and nothing of the design is kept. */
export async function mayClose(): Promise<boolean> {
  if (!(await mayLeave()) || !(await mayLeaveMachine())) return false;
  await closeDesign();
  return true;
}

export async function quit(): Promise<void> {
  if (await mayClose()) await platform.close();
}
