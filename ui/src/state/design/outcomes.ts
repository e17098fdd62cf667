/** What the figures of a form would make, which is asked for while they are typed. */

import { create } from "zustand";
import type { EditRequest } from "../../generated/requests";
import type { EditOutcome } from "../../generated/responses";
import { platform } from "../../platform";

/** A form that says what it would make. */
export type OutcomeForm = "fillet" | "shape";

interface Answer {
  /** The name of the question. */
  readonly to: string;
  readonly outcome: EditOutcome | null;
  /** Why the edit would be refused. */
  readonly problem: string | null;
}

/** The last answer to each form. */
export const useOutcomes = create<Readonly<Record<OutcomeForm, Answer | null>>>()(() => ({
  fillet: null,
  shape: null,
}));

interface Question {
  readonly to: string;
  readonly request: EditRequest;
}

const wanted: Record<OutcomeForm, Question | null> = { fillet: null, shape: null };
const asking: Record<OutcomeForm, boolean> = { fillet: false, shape: false };

/**
 * Asks what an edit would make. A form has one question on its way at a time; of those that come meanwhile only the last is
 * asked. `to` names the question: with the same figures of another design it is another one.
 */
export function askForOutcome(form: OutcomeForm, to: string, request: EditRequest): void {
  wanted[form] = { to, request };
  if (!asking[form]) void askWanted(form);
}

async function askWanted(form: OutcomeForm): Promise<void> {
  asking[form] = true;
  for (let question = wanted[form]; question; question = wanted[form]) {
    wanted[form] = null;
    const { to, request } = question;
    let [outcome, problem]: [EditOutcome | null, string | null] = [null, null];
    try {
      ({ outcome } = await platform.ask("outcome", { request }));
    } catch (error) {
      problem = error instanceof Error ? error.message : String(error);
    }
    useOutcomes.setState({ [form]: { to, outcome, problem } });
  }
  asking[form] = false;
}
