import { useEffect, useState } from "react";
import { Field } from "../../shared/controls/Field";
import { NumberField } from "../../shared/controls/NumberField";
import { count, roundedDown, roundedUp } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { tell } from "../../state/asking/problems";
import { useDesign } from "../../state/design/design";
import { fillet, selectedCorners } from "../../state/design/operations";
import { useSelection } from "../../state/design/selection";
import { whyNot } from "../../state/window/commands";
import { useFigure } from "./figure";
import { Do } from "./forms";
import { needs, Outcome, useOutcome } from "./Outcome";

/** What a fillet of the selected corners would come to: a sentence, whether it can be made, and a radius that fits better. */
interface Prospect {
  readonly fits: boolean | null;
  readonly text: string;
  /** The nearest radius of which *Check* does not warn, or at least one that fits, mm; null where none is needed, or none does. */
  readonly nearest: number | null;
}

const NOTHING: Prospect = { fits: null, text: "Select corners to see the chords.", nearest: null };

/** What the figures would make of the selected corners, while they are typed. `over`: these corners are rounded already. */
function useProspect(radius: number, step: number, over: boolean): Prospect {
  useDesign();
  useSelection();
  const vertices = selectedCorners();
  const asked = { edit: "fillet", vertices, radius_mm: radius, step_deg: step } as const;
  const answer = useOutcome("fillet", vertices.length > 0 && !over ? asked : null);
  const { length } = useLengths();
  if (over) return { fits: null, text: "Done. Select the next corners.", nearest: null };
  if (vertices.length === 0) return NOTHING;
  if (answer?.problem) return { fits: false, text: answer.problem, nearest: null };
  const found = answer?.outcome;
  if (found?.outcome === "fillet") {
    const chords = found.chords.reduce((sum, of) => sum + of, 0);
    const on = `${count(chords, "chord")} on ${count(found.chords.length, "corner")}`;
    const text = `${on}, the shortest ${length(found.shortest_mm)}${needs(found.needed_mm, length)}.`;
    if (found.clear_mm === radius) return { fits: true, text, nearest: null };
    return { fits: true, text: `${text} Check warns of a length near a limit.`, nearest: found.clear_mm };
  }
  if (found?.outcome !== "no-fillet") return { fits: null, text: "", nearest: null };
  const { part, vertex, nearest_mm: nearest } = found;
  const what = part === "chords" ? `Two chords at vertex ${vertex} would be` : `An edge at vertex ${vertex} would keep`;
  const text = `${what} ${length(found.length_mm)}${needs(found.needed_mm, length)}.`;
  return { fits: false, text: nearest === null ? `${text} No radius fits.` : text, nearest };
}

/** What is selected of which design, as a name. */
const selectedNow = () => `${useDesign.getState().version}: ${selectedCorners().join(" ")}`;

/** The corners that were rounded last, in the design as that has left it: until one of the two changes there is nothing to round. */
function useRounded() {
  useDesign();
  useSelection();
  const [rounded, setRounded] = useState<string | null>(null);
  return { over: rounded === selectedNow(), isMade: () => setRounded(selectedNow()) };
}

/** A radius in the place of one that a person has not set: once for what is selected, since a rounded figure may not fit either. */
function useProposal(radius: ReturnType<typeof useFigure>, step: number, nearest: number | null): number | null {
  const to = `${selectedNow()}, ${step}`;
  const [tried, setTried] = useState<string | null>(null);
  const proposed = radius.own || tried === to ? null : nearest;
  const { propose } = radius;
  useEffect(() => {
    if (proposed === null) return;
    setTried(to);
    propose(proposed);
  }, [proposed, propose, to]);
  return proposed;
}

/** Corners rounded by a radius. What comes out is told: the machine's shortest edge decides how many chords there are. */
export function FilletForm() {
  const radius = useFigure(30);
  const step = useFigure(15);
  const { length, unit } = useLengths();
  const { over, isMade } = useRounded();
  const { fits, text, nearest: bound } = useProspect(radius.now, step.now, over);
  // What is named is what is taken: it is rounded to where it still fits, away from the radius that does not.
  const nearest = bound === null ? null : (bound < radius.now ? roundedDown : roundedUp)(bound, unit);
  const proposed = useProposal(radius, step.now, nearest);
  const why = over
    ? "These corners are rounded."
    : fits !== false || proposed !== null
      ? null
      : nearest === null
        ? "No fillet can be made here: see above."
        : `The nearest radius that fits is ${length(nearest)}.`;
  const make = async (by: number) => {
    if (whyNot("fillet") || why) return;
    const made = await fillet(by, step.value);
    if (!made) return;
    isMade();
    const chords = `${count(made.chords, "chord")}, the shortest ${length(made.shortest)}`;
    tell("info", `${count(made.corners, "corner")} rounded to a radius of ${length(by)} with ${chords}.`, "fillet");
  };
  return (
    <>
      <Field label="Radius" hint="Of the arc that the chords follow.">
        {({ id }) => <NumberField id={id} label="Radius" {...radius.field} onEnter={(entered) => void make(entered)} />}
      </Field>
      <Field label="Step" hint="Largest bend angle between two chords. No chord is shorter than the machine can make.">
        {({ id }) => <NumberField id={id} kind="angle" label="Step" min={1} max={90} {...step.field} />}
      </Field>
      <Outcome
        fits={proposed === null ? fits : null}
        text={proposed === null ? text : ""}
        use={
          nearest === null || proposed !== null
            ? null
            : { label: `Use ${length(nearest)}`, take: () => radius.set(nearest) }
        }
      />
      <Do command="fillet" why={why} onDo={() => void make(radius.value)}>
        Fillet
      </Do>
    </>
  );
}
