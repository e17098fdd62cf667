import { create } from "zustand";
import type { DiagnosticReport, FixAll, LiveCheck } from "../../../generated/responses";
import { asking } from "../../asking/work";
import { useDesign } from "../design";

type Code = DiagnosticReport["code"];

interface FixAllStore {
  /** The checks that the answers are of. */
  readonly of: LiveCheck | null;
  /** What fixes all of a kind; null while it is looked for, and where nothing does. */
  readonly found: ReadonlyMap<Code, { readonly looking: boolean; readonly all: FixAll | null }>;
}

export const useFixAll = create<FixAllStore>()(() => ({ of: null, found: new Map() }));

function put(of: LiveCheck, code: Code, looking: boolean, all: FixAll | null): void {
  useFixAll.setState((store) => {
    const before = store.of === of ? store.found : new Map();
    return { of, found: new Map(before).set(code, { looking, all }) };
  });
}

/** Asks what would fix all findings of a kind in the design as it is, unless that was asked. While vertices are dragged the checks are of another design. */
export async function needFixAll(code: Code): Promise<void> {
  const { limits, dragged } = useDesign.getState();
  const { of, found } = useFixAll.getState();
  if (!limits || dragged.length > 0 || (of === limits && found.has(code))) return;
  put(limits, code, true, null);
  // An offer: where none can be had, each finding has its own fixes.
  const { all } = await asking("fix-all", { code }).catch(() => ({ all: null }));
  if (useFixAll.getState().of === limits) put(limits, code, false, all);
}
