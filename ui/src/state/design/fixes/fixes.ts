import { create } from "zustand";
import type { Collisions, DiagnosticReport, Fix, FixPreview, LiveCheck } from "../../../generated/responses";
import type { Preview, SceneDesign, Vec3 } from "../../../scene/interface";
import { tell } from "../../asking/problems";
import { asking } from "../../asking/work";
import { useView } from "../../window/view";
import { edit, useDesign } from "../design";
import { isCollision } from "../findings";

/** Fixes are asked for once the design has come to rest, ms. */
export const REST = 350;

interface FixStore {
  /** Of the checks without collisions, then of collisions. */
  readonly fixes: readonly Fix[];
  /** The checks that they are of; others have to be asked for when these are others. */
  readonly of: LiveCheck | null;
  readonly ofCollisions: Collisions | null;
  /** Over once the fixes of collisions are there. */
  readonly asked: Promise<void>;
  /** The one that is shown in the view. */
  readonly shown: Fix | null;
}

export const useFixes = create<FixStore>()(() => ({
  fixes: [],
  of: null,
  ofCollisions: null,
  asked: Promise.resolve(),
  shown: null,
}));

const ofLimits = ({ mends }: Fix): boolean => !isCollision(mends.code);
const ofCollisions = (fix: Fix): boolean => !ofLimits(fix);

/** Asks for the fixes of the checks as they are, unless they were asked for. */
export async function needFixes(): Promise<void> {
  await Promise.all([needFixesOfLimits(), needFixesOfCollisions()]);
}

async function needFixesOfLimits(): Promise<void> {
  const { limits } = useDesign.getState();
  if (!limits || useFixes.getState().of === limits) return;
  useFixes.setState(({ fixes }) => ({ of: limits, fixes: fixes.filter(ofCollisions) }));
  // Fixes are an offer: where none can be had the checks say anyway what is wrong.
  const { fixes: found } = await asking("fixes", {}).catch(() => ({ fixes: [] }));
  if (useFixes.getState().of !== limits) return;
  useFixes.setState(({ fixes }) => ({ fixes: [...found, ...fixes.filter(ofCollisions)] }));
}

function needFixesOfCollisions(): Promise<void> {
  const found = useDesign.getState().collisions?.found ?? null;
  if (useFixes.getState().ofCollisions !== found) {
    useFixes.setState(({ fixes }) => ({ ofCollisions: found, fixes: fixes.filter(ofLimits) }));
    useFixes.setState({ asked: askForFixesOf(found) });
  }
  return useFixes.getState().asked;
}

async function askForFixesOf(found: Collisions | null): Promise<void> {
  if (!found || found.contacts.length === 0) return;
  const { fixes: more } = await asking("fixes", { collisions: true }).catch(() => ({ fixes: [] }));
  if (useFixes.getState().ofCollisions !== found) return;
  useFixes.setState(({ fixes }) => ({ fixes: [...fixes.filter(ofLimits), ...more] }));
}

const same = (a: DiagnosticReport, b: DiagnosticReport): boolean =>
  a.code === b.code &&
  (a.vertex ?? null) === (b.vertex ?? null) &&
  (a.edge ?? null) === (b.edge ?? null) &&
  (a.step ?? null) === (b.step ?? null);

export function fixesOf(report: DiagnosticReport, fixes: readonly Fix[]): Fix[] {
  return fixes.filter(({ mends }) => same(mends, report));
}

/** What a fix would do, as the view draws it. */
export function previewOf(
  { moved, doubled, gone_edges, new_edges, detached }: FixPreview,
  { vertices, edges }: SceneDesign,
): Preview {
  const places = new Map(moved.map(({ vertex, at_mm }) => [vertex, at_mm as Vec3]));
  const place = (id: number): Vec3 | undefined => places.get(id) ?? vertices.get(id)?.at;
  const removed = new Set(gone_edges);
  const drawn: [Vec3, Vec3][] = new_edges.map(([a, b]) => [a, b]);
  const lit = new Set([...doubled, ...detached.flat()]);
  for (const { id, a, b } of edges.values()) {
    const goes = places.has(a) || places.has(b);
    const [from, to] = [place(a), place(b)];
    if (from && to && !removed.has(id) && (goes || lit.has(id))) drawn.push([from, to]);
    if (goes) removed.add(id);
  }
  return { edges: drawn, removed };
}

export function showFix(fix: Fix | null): void {
  useFixes.setState({ shown: fix });
  useView.setState({ preview: fix ? previewOf(fix.preview, useDesign.getState()) : null });
}

/** Nothing is shown any more: of another design, or of one that is dragged elsewhere just now, the fix would be another. */
export function hideFix(): void {
  if (useFixes.getState().shown) showFix(null);
}

/** How many wires there are by the checks; 0 where they do not know. */
const wiresNow = (): number => useDesign.getState().limits?.wires.length ?? 0;

export const makesMoreWires = ({ after: { wires } }: Fix): boolean => wiresNow() > 0 && wires > wiresNow();

/** "3 wires instead of 1", where a fix leaves another number of wires than the checks know; null where it does not. */
export function otherWires({ after: { wires } }: Fix): string | null {
  const now = wiresNow();
  return now === 0 || wires === now ? null : `${wires} ${wires === 1 ? "wire" : "wires"} instead of ${now}`;
}

/** The view has given up the preview. */
export function previewGone(): void {
  if (useFixes.getState().shown) useFixes.setState({ shown: null });
}

/** Makes it: one change, which undo takes back. */
export async function applyFix(fix: Fix): Promise<boolean> {
  showFix(null);
  const changed = otherWires(fix);
  // Which wires there are is seen nowhere in the view: who has not read the offer would cut stock for one.
  const made = await edit(fix.edit);
  if (made && changed) tell("info", `${fix.title}: ${changed}. Undo takes it back.`, "more-wires");
  return made !== null;
}
