import { useEffect } from "react";
import { create } from "zustand";
import type { ExampleEntry } from "../../generated/responses";
import { platform } from "../../platform";
import { told } from "../../state/asking/problems";

const useExamples = create<{ readonly examples: readonly ExampleEntry[] | null }>()(() => ({ examples: null }));

let asked = false;

/** The examples; null until they are there. They are asked for once. */
export function useNeededExamples(): readonly ExampleEntry[] | null {
  useEffect(() => {
    if (asked) return;
    asked = true;
    void told(platform.ask("examples", {})).then((answer) => {
      if (answer) useExamples.setState({ examples: answer.examples });
      else asked = false;
    });
  }, []);
  return useExamples(({ examples }) => examples);
}
