// @vitest-environment happy-dom
import { act } from "react";
import { createRoot, type Root } from "react-dom/client";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { DiagnosticReport, Fix, LiveCheck } from "../../generated/responses";
import { useDesign } from "../../state/design/design";
import { useFixAll } from "../../state/design/fixes/fix_all";
import { REST, useFixes } from "../../state/design/fixes/fixes";
import { useSelection } from "../../state/design/selection";
import { closeProfile, useProfile } from "../../state/machine/profile";
import { designState } from "../../state/testing";
import { useUi } from "../../state/window/ui";
import { GroupLine } from "./GroupLine";

Object.assign(globalThis, { IS_REACT_ACT_ENVIRONMENT: true });

let host: HTMLElement;
let root: Root;
type DesignDragged = ReturnType<typeof useDesign.getState>["dragged"];

const report = (code: DiagnosticReport["code"], more: Partial<DiagnosticReport> = {}): DiagnosticReport => ({
  code,
  severity: "error",
  message: code,
  help: "",
  ...more,
});
const short = report("edge_too_short", { edge: 7, edges: [7] });
const fix = {
  title: "Move vertex 3",
  mends: short,
  edit: { edit: "place", positions: [] },
  after: { wires: 1, length_mm: null, stock_mm: null, time_s: null, cost: null },
  errors_after: 0,
  change: { length_mm: null, stock_mm: null, time_s: null, cost: null, currency: null },
} as unknown as Fix;

beforeEach(() => {
  vi.useFakeTimers();
  host = document.createElement("div");
  document.body.append(host);
  root = createRoot(host);
  const check: LiveCheck = { feasible: false, diagnostics: [short], wires: [], limits_unknown: null };
  useDesign.setState({ check, limits: check, dragged: [], surfaces: new Map() });
  useFixes.setState({ fixes: [fix], of: check, shown: null });
});
afterEach(() => {
  act(() => root.unmount());
  host.remove();
  vi.useRealTimers();
});

const show = (reports: DiagnosticReport[]) =>
  act(() => root.render(<GroupLine group={{ key: "x", severity: "error", reports }} />));
/** Opens the fixes, and waits until the design counts as at rest. */
const openAndRest = async () => {
  await act(async () => button("Fix…").click());
  await act(async () => void (await vi.advanceTimersByTimeAsync(REST)));
};
const button = (text: string): HTMLButtonElement => {
  const found = [...host.querySelectorAll("button")].find(({ textContent }) => textContent === text);
  if (!found) throw new Error(`no button ${text}`);
  return found;
};

describe("a line of the checks", () => {
  it("makes a fix once, however often it is clicked", async () => {
    platform.ask.mockReset().mockReturnValue(new Promise(() => {}));
    show([short]);
    act(() => button("Fix…").click());
    act(() => button("Apply").click());
    act(() => button("Apply").click());
    // An edit takes its turn among others.
    await act(async () => {});
    expect(platform.ask.mock.calls.filter(([name]) => name === "edit").length).toBe(1);
  });

  it("offers a fix as soon as one is found", () => {
    useFixes.setState({ fixes: [] });
    show([short]);
    act(() => button("Show").focus());
    act(() => useFixes.setState({ fixes: [fix] }));
    expect(button("Fix…").getAttribute("aria-expanded")).toBe("false");
  });

  it("leads to the body that is hit where nobody has measured it", async () => {
    platform.ask.mockReset().mockReturnValue(new Promise(() => {}));
    useDesign.setState({ state: designState({ machine: "mine" }) });
    const hit = (body: string, estimated: boolean) =>
      report("meets_machine", {
        body,
        unit: "mm",
        value: 3,
        remedies: estimated ? [{ remedy: "measure_body" }] : [],
      });
    show([hit("peg", false), hit("head", true)]);
    await act(async () => button("List").click());
    await act(async () => button("Enter dimensions…").click());
    expect(useProfile.getState()).toMatchObject({ open: { id: "mine" }, part: "bodies", body: "head" });
    show([hit("peg", false), hit("nozzle", false)]);
    expect(host.textContent).not.toContain("Enter dimensions");
    closeProfile();
  });

  it("highlights nothing any more when it goes away under the pointer", () => {
    show([short]);
    act(() => void host.querySelector("li")?.dispatchEvent(new PointerEvent("pointerover", { bubbles: true })));
    expect([...useSelection.getState().highlight.edges]).toEqual([7]);
    act(() => root.render(null));
    expect([...useSelection.getState().highlight.edges]).toEqual([]);
  });

  it("offers one change for all of a kind, with what it fixes and leaves", async () => {
    const other = report("edge_too_short", { edge: 9, edges: [9] });
    const all = { fix: { ...fix, title: "Fix 2 of 3 places" }, fixed: 2, of: 3 };
    platform.ask.mockReset().mockResolvedValue({ all });
    show([short, other]);
    await openAndRest();
    expect(platform.ask.mock.calls).toEqual([["fix-all", { code: "edge_too_short" }]]);
    expect(host.querySelector(".fix-all")?.textContent).toContain("Fixes 2 places, 1 left");
    expect(button("Apply").getAttribute("aria-disabled")).toBeNull();
  });

  it("offers no change of all where none is better than the design as it is", async () => {
    platform.ask.mockReset().mockResolvedValue({ all: null });
    useFixAll.setState({ of: null, found: new Map() });
    show([short, report("edge_too_short", { edge: 9, edges: [9] })]);
    await openAndRest();
    expect(platform.ask.mock.calls.length).toBe(1);
    expect(host.querySelector(".fix-all")).toBeNull();
  });

  it("looks for one change of all only once the design is at rest", async () => {
    platform.ask.mockReset().mockResolvedValue({ all: null });
    useFixAll.setState({ of: null, found: new Map() });
    show([short, report("edge_too_short", { edge: 9, edges: [9] })]);
    await openAndRest();
    const checked = (dragged: DesignDragged) =>
      act(async () => {
        const check: LiveCheck = { feasible: false, diagnostics: [short], wires: [], limits_unknown: null };
        useDesign.setState({ check, limits: check, dragged });
        await vi.advanceTimersByTimeAsync(REST / 2);
      });
    for (let k = 0; k < 5; k++) await checked([{ vertex: 1, at: [k, 0, 0] }]);
    await act(async () => void (await vi.advanceTimersByTimeAsync(2 * REST)));
    expect(platform.ask.mock.calls.length).toBe(1);
    await checked([]);
    await checked([]);
    expect(platform.ask.mock.calls.length).toBe(1);
    await act(async () => void (await vi.advanceTimersByTimeAsync(REST)));
    expect(platform.ask.mock.calls.length).toBe(2);
  });

  it("leads to the wires where the wire does not fit the machine", () => {
    useUi.setState({ open: [] });
    show([report("wire_does_not_fit")]);
    act(() => button("Choose a wire").click());
    expect(useUi.getState().open).toEqual(["machine"]);
  });

  it("selects the smaller parts of several", () => {
    useDesign.setState({
      edges: new Map(
        [
          [1, 2],
          [2, 3],
          [8, 9],
        ].map(([a = 0, b = 0], id) => [id, { id, a, b }]),
      ),
    });
    show([report("several_wires", { value: 2 })]);
    act(() => button("Select the smaller").click());
    expect([...useSelection.getState().vertices]).toEqual([8, 9]);
  });
});
