/** The check for collisions: it takes longer than the others, follows them, and is given up for a later one. */

import { create } from "zustand";
import type { Collisions } from "../../generated/responses";
import { platform } from "../../platform";
import { asking } from "../asking/work";
import { useMachines } from "../machine/machines";
import { type CollisionsOf, type DesignStore, movedOf, showCollisions, useDesign } from "./design";

/** An answer within so many ms comes while a person drags, and that of the place before stays until then. */
const QUICK = 100;
/** What takes longer than so many ms is said to take long, and can be stopped. */
const LONG = 2000;

/** How the check for collisions stands: */
type Standing =
  /** there is nothing to look at; */
  | "none"
  /** it is under way; */
  | "running"
  /** it takes too long to be made while a person drags; */
  | "waiting"
  /** a person has stopped it; */
  | "stopped"
  /** it could not be made; */
  | "failed"
  /** it is done. */
  | "done";

interface CollisionStore {
  readonly stands: Standing;
  /** Whether what is under way takes long. */
  readonly long: boolean;
  /** Why it could not be made. */
  readonly problem: string | null;
}

const NONE: CollisionStore = { stands: "none", long: false, problem: null };

export const useCollisions = create<CollisionStore>()(() => NONE);

/** Whether collisions are known, are being looked for, or are not. */
export type Known = "checked" | "checking" | "unchecked";

/** What is known of collisions: what was found before counts until the next answer is there. */
export function useKnown(): Known {
  const found = useDesign(({ collisions }) => collisions?.found);
  const stands = useCollisions((store) => store.stands);
  if (found?.checked) return "checked";
  return stands === "running" && !found ? "checking" : "unchecked";
}

type Question = Pick<DesignStore, "version" | "dragged"> & Pick<CollisionsOf, "profiles">;

/** Whether they are those of the design and the profiles as they are. */
export const isCurrent = ({ version, profiles }: Pick<CollisionsOf, "version" | "profiles">): boolean =>
  version === useDesign.getState().version && profiles === useMachines.getState().changes;

let wanted: Question | null = null;
/** When the one that is under way was begun; null where none is. */
let since: number | null = null;
/** How long the last answer has taken, ms; null before the first. */
let took: number | null = null;

/** Looks for collisions where the other checks have said how things stand. */
export function lookForCollisions(): void {
  const { limits, dragged, version, collisions } = useDesign.getState();
  const isQuick = took !== null && took <= QUICK;
  // Without a program there is nothing that could hit anything.
  const no = !limits?.wires.some(({ bends }) => bends !== null);
  if (no || (dragged.length > 0 && !isQuick)) {
    putOff(no ? "none" : "waiting");
    return;
  }
  const profiles = useMachines.getState().changes;
  // What was found in another design or with another profile says nothing of this one.
  const stays = !collisions || isCurrent(collisions) || (isQuick && collisions.profiles === profiles);
  if (!stays) showCollisions(null);
  wanted = { version, profiles, dragged };
  if (since === null) void lookForWanted();
  else if (performance.now() - since > QUICK) void stop();
}

/** A person does not want to wait for it any more. */
export function stopCollisions(): void {
  putOff("stopped");
}

function putOff(stands: Standing): void {
  wanted = null;
  if (since !== null) void stop();
  showCollisions(null);
  useCollisions.setState({ ...NONE, stands });
}

/** Until an order to stop is answered: it would stop a question that comes before it does. */
let stopping: Promise<unknown> | null = null;

async function stop(): Promise<void> {
  // What cannot be stopped is answered some time, and the answer left aside.
  const order = platform.ask("stop-collisions", {}).catch(() => {});
  stopping = order;
  await order;
  if (stopping === order) stopping = null;
}

async function lookForWanted(): Promise<void> {
  while (wanted) {
    since = performance.now();
    useCollisions.setState({ ...NONE, stands: "running" });
    while (stopping) await stopping;
    const question: Question | null = wanted;
    if (!question) break;
    const { version, profiles, dragged } = question;
    wanted = null;
    since = performance.now();
    const later = setTimeout(() => useCollisions.setState({ long: true }), LONG);
    let [found, problem]: [Collisions | null, string | null] = [null, null];
    try {
      found = await asking("collisions", { moved: movedOf(dragged) });
    } catch (error) {
      problem = error instanceof Error ? error.message : String(error);
    }
    clearTimeout(later);
    if (found && !found.stopped) took = performance.now() - since;
    since = null;
    // Of a design that is another one by now it says nothing.
    const holds = isCurrent({ version, profiles }) && useCollisions.getState().stands === "running";
    if (!holds) continue;
    if (found && !found.stopped) showCollisions({ found, version, profiles, dragged: dragged.length > 0 });
    if (wanted) continue;
    if (problem !== null || found?.stopped) showCollisions(null);
    useCollisions.setState({
      stands: problem !== null ? "failed" : found?.stopped ? "stopped" : "done",
      long: false,
      problem,
    });
  }
  since = null;
}
