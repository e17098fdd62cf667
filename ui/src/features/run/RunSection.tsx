import { useEffect } from "react";
import { Section } from "../../shared/Section";
import { isOpen, loadRuns, takeUp, useRun } from "../../state/run";
import { phrase } from "./buttons";
import { Connect } from "./Connect";
import { Console } from "./Console";
import { Manual } from "./Manual";
import { QuestionDialog } from "./QuestionDialog";
import { unfinishedOf } from "./records";
import { Runs } from "./Runs";
import { Session } from "./Session";
import { Wire } from "./Wire";
import "./run.css";

/** The machine itself: connecting, moving, making. */
export function RunSection() {
  const state = useRun((run) => run.state);
  const interrupted = useRun(({ state, runs }) => state === null && unfinishedOf(runs).length > 0);
  useEffect(() => {
    void takeUp();
    void loadRuns();
  }, []);
  const connected = isOpen(state);
  const tone = state?.phase === "failed" ? "error" : state?.phase === "stopped" || state?.unfinished || interrupted ? "warning" : null;
  return (
    <>
      <Section id="run" title="Run" phrase={phrase(state)} tone={tone}>
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
