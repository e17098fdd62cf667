import { useEffect } from "react";
import { useDesign } from "../../state/design/design";
import { makeProgram, useProgram, useStale } from "../../state/program/program";
import { useRunFile } from "../../state/program/run_file";
import { useUi } from "../../state/window/ui";
import { Section } from "../panel/Section";
import { Contacts } from "./Contacts";
import { Expected } from "./Expected";
import { Generate } from "./Generate";
import { Pause } from "./Pause";
import { Player } from "./Player";
import { Shown } from "./Shown";
import { StepTable } from "./StepTable";
import { phrase } from "./steps";
import "./animate.css";

/** How long the design has to be left alone before the program is made anew, ms. */
const REST_MS = 400;

/** The program, step by step. */
export function AnimateSection() {
  const { program, asking, problem } = useProgram();
  const stale = useStale();
  const check = useDesign((design) => design.check);
  const some = program !== null && program.wires.length > 0;
  return (
    <Section id="animate" title="Animate" phrase={header()} tone={some && stale ? "warning" : null}>
      <Updates />
      <Generate />
      {some && (
        <>
          <Player />
          <Contacts />
          <Shown />
          <Expected />
          <StepTable />
          <Pause />
        </>
      )}
    </Section>
  );

  function header(): string {
    if (asking) return "generating…";
    if (some && stale) return "changed since";
    if (program) return phrase(program.wires, program.without);
    if (problem) return "no program";
    const wires = check?.wires ?? [];
    return wires.length > 0 && wires.every(({ time_s }) => time_s !== null) ? phrase(wires, 0) : "not generated yet";
  }
}

/** Brings the program up to date when the design is left alone for a moment, as long as the section is open. */
function Updates() {
  const open = useUi((ui) => ui.open.includes("animate"));
  const { vertices, edges, state } = useDesign();
  const stale = useStale();
  const file = useRunFile((run) => run.file);
  const made = useProgram((program) => program.basis !== null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: each change of the design begins the rest anew
  useEffect(() => {
    if (!open || (made && !stale) || (edges.size === 0 && !file)) return;
    const timer = window.setTimeout(() => void makeProgram(), REST_MS);
    return () => window.clearTimeout(timer);
  }, [open, made, stale, vertices, edges, state, file]);
  return null;
}
