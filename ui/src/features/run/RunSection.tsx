import { useEffect } from "react";
import { dismissAll, tell } from "../../state/asking/problems";
import { isOpen, loadRuns, reattach, useRun } from "../../state/machine/run";
import { Section } from "../panel/Section";
import { phrase } from "./buttons";
import { Manual } from "./by_hand/Manual";
import { Connect } from "./Connect";
import { Console } from "./console/Console";
import { ToRun } from "./file/ToRun";
import { QuestionDialog } from "./questions/QuestionDialog";
import { Runs } from "./records/Runs";
import { interruptedPhrase, unfinishedOf } from "./records/records";
import { Session } from "./Session";
import { Wire } from "./Wire";
import "./run.css";
import { useUnits } from "../../state/window/units";

const INTERRUPTED = "interrupted";

/** The machine itself: connecting, moving, bending. */
export function RunSection() {
  const state = useRun((run) => run.state);
  const interrupted = useRun(({ state, runs }) => state === null && unfinishedOf(runs).length > 0);
  useEffect(() => {
    void (async () => {
      await Promise.all([reattach(), loadRuns()]);
      const { state, runs } = useRun.getState();
      const told = interruptedPhrase(runs, useUnits.getState().unit);
      // The section may be out of sight, and the wire is still in the machine.
      if (state === null && told) tell("warning", `${told.what}. ${told.sub}`, INTERRUPTED, true);
    })();
  }, []);
  const connected = isOpen(state);
  useEffect(() => {
    // From here on the machine's own section shows its wire.
    if (connected) dismissAll(INTERRUPTED);
  }, [connected]);
  const tone =
    state?.phase === "failed"
      ? "error"
      : state?.phase === "stopped" || state?.unfinished || interrupted
        ? "warning"
        : null;
  return (
    <>
      <Section id="run" title="Run" phrase={phrase(state)} tone={tone}>
        <ToRun state={state} />
        {connected && state ? (
          <>
            <Session state={state} />
            {/* What failed for good can only be connected again; that lets go of the session that is there. */}
            {state.phase === "failed" && <Connect />}
            <Wire state={state} />
            <Manual state={state} />
          </>
        ) : (
          <Connect />
        )}
        <Runs />
        <Console />
      </Section>
      <QuestionDialog />
    </>
  );
}
