import { create } from "zustand";
import { Refused } from "../../platform";

/** Something that went wrong, or that a person should know. */
export interface Problem {
  readonly id: number;
  readonly severity: "error" | "warning" | "info";
  /** What is wrong, where, and what to do. */
  readonly message: string;
  /** The name that stays the same while the wording may change. */
  readonly code: string;
  /** Whether a person has to do something about it: it is there until it is dismissed or over, while others go by themselves. */
  readonly stays: boolean;
}

interface ProblemStore {
  readonly problems: readonly Problem[];
}

export const useProblems = create<ProblemStore>()(() => ({ problems: [] }));

let next = 1;

export function tell(severity: Problem["severity"], message: string, code = "", stays = false): void {
  const problem = { id: next++, severity, message, code, stays };
  useProblems.setState(({ problems }) => ({
    // The same once more is no news.
    problems: [...problems.filter((other) => other.message !== message), problem],
  }));
}

export function dismiss(id: number): void {
  useProblems.setState(({ problems }) => ({ problems: problems.filter((problem) => problem.id !== id) }));
}

/** All of them were read. */
export function dismissEverything(): void {
  useProblems.setState({ problems: [] });
}

/** What was shown under this code is over. */
export function dismissAll(code: string): void {
  useProblems.setState(({ problems }) => ({ problems: problems.filter((problem) => problem.code !== code) }));
}

/** Waits for an answer; a refusal is shown to the person, and null is the answer. */
export async function told<T>(asked: Promise<T>): Promise<T | null> {
  try {
    return await asked;
  } catch (error) {
    const code = error instanceof Refused ? error.refusal.code : "failure";
    tell("error", error instanceof Error ? error.message : String(error), code);
    return null;
  }
}
