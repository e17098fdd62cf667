import { useEffect, useLayoutEffect, useRef, useState } from "react";
import { Button } from "../../shared/controls/Button";
import { useDesign } from "../../state/design/design";
import { dismissHints, goToHint, useHints } from "../../state/window/hints";
import { beside } from "./beside";
import "./start.css";

interface Hint {
  readonly title: string;
  readonly text: string;
  /** Beside what it stands. */
  readonly beside: string;
  readonly side: "left" | "below";
}

const HINTS: readonly Hint[] = [
  {
    title: "Start with a shape",
    text: "Trace on a model, draw on a plane, or open a drawing. Each tool has a key; ? lists them all.",
    beside: ".toolbar",
    side: "below",
  },
  {
    title: "Choose the machine and the wire",
    text: "They set what can be bent. Both stay here in the top bar and can be changed at any time.",
    beside: ".top-made",
    side: "below",
  },
  {
    title: "See what has to be fixed",
    text: "Check lists what the machine cannot bend and why. Click a line to see the place. Each fix shows what it would change.",
    beside: "#section-check",
    side: "left",
  },
  {
    title: "Take it to the machine",
    text: "Animate plays the bending, Export writes files, Run moves the machine. STOP is always at the top right: Ctrl Space.",
    beside: "#section-run",
    side: "left",
  },
];

/** Four steps of a first look around: beside what they are about, out of the way. */
export function Hints() {
  const step = useHints((hints) => hints.step);
  const ready = useDesign(({ state }) => state !== null);
  // A user who has brought a shape needs no hint for it.
  const brought = useDesign(({ vertices, surfaces }) => vertices.size > 0 || surfaces.size > 0);
  useEffect(() => {
    if (step === 0 && brought) goToHint(1);
  }, [step, brought]);
  const hint = step === null ? undefined : HINTS[step];
  if (!ready || step === null || !hint) return null;
  return <Bubble key={step} hint={hint} step={step} />;
}

function Bubble({ hint, step }: { readonly hint: Hint; readonly step: number }) {
  const bubble = useRef<HTMLDivElement>(null);
  const [at, setAt] = useState<{ left: number; top: number } | null>(null);
  useLayoutEffect(() => {
    const place = () => {
      const box = (selector: string) => document.querySelector(selector)?.getBoundingClientRect() ?? null;
      const [from, view, own] = [box(hint.beside), box(".viewport"), bubble.current?.getBoundingClientRect()];
      if (from && view && own) setAt(beside(hint.side, from, view, box(".view-corner"), own));
    };
    place();
    const watch = new ResizeObserver(place);
    watch.observe(document.body);
    return () => watch.disconnect();
  }, [hint]);
  const last = step === HINTS.length - 1;
  return (
    <div
      ref={bubble}
      className={`hint ${hint.side}`}
      role="note"
      aria-label="First steps"
      style={at ? { left: at.left, top: at.top } : { visibility: "hidden" }}
    >
      <strong>{hint.title}</strong>
      <p>{hint.text}</p>
      <div className="row">
        <span className="muted small grow">
          {step + 1} of {HINTS.length}
        </span>
        {!last && (
          <Button kind="quiet" small onClick={dismissHints}>
            Skip
          </Button>
        )}
        <Button kind="primary" small onClick={() => (last ? dismissHints() : goToHint(step + 1))}>
          {last ? "Done" : "Next"}
        </Button>
      </div>
    </div>
  );
}
