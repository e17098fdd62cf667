// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
vi.mock("../../platform", () => ({ platform: { ask }, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { select } from "../../state/design/selection";
import { forgetFrame, useFrame } from "../../state/frame/frame";
import { useShape } from "../../state/frame/shape";
import { frameShown, movedFrame, smallFrame } from "../../state/frame/testing";
import { designState } from "../../state/testing";
import { useUi } from "../../state/window/ui";
import { FrameSection } from "./FrameSection";

const at = place();

beforeEach(() => {
  ask.mockReset();
  ask.mockImplementation(async (name: string) => {
    if (name === "frame") return frameShown();
    if (name === "frame-choices") return { errors: [{ id: "bend-forming", name: "Bend-Forming" }], strut_builders: [] };
    return { machines: [], materials: [] };
  });
  forgetFrame();
  useUi.setState({ open: ["frame"] });
  useDesign.setState({ ...smallFrame(), state: designState(), version: 1 });
});

const button = (name: string) =>
  [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === name);
const openLoads = () => act(() => at.host.querySelector<HTMLButtonElement>(".fold-head")?.click());
const press = (name: string) => act(async () => button(name)?.click());

it("has nothing to compute without a design", () => {
  useDesign.setState({ vertices: new Map(), edges: new Map() });
  at.show(<FrameSection />);
  expect(at.host.textContent).toContain("Draw or open a design.");
  expect(button("Compute")).toBeUndefined();
});

it("computes, lists figures with their places, and shows modes on demand", async () => {
  at.show(<FrameSection />);
  await press("Compute");
  const table = at.host.querySelector('[aria-label="Results"]')?.textContent;
  expect(table).toContain("Largest displacement0.5 mmvertex 2");
  expect(table).toContain("Utilisation20 %edge 1");
  expect(table).toContain("Compression4 Nedge 0");
  expect(table).toContain("Lowest frequency12.3 Hz");
  expect(table).toContain("12.5 g");
  const modes = at.host.querySelectorAll<HTMLButtonElement>('[aria-label="Modes"] button');
  act(() => modes[1]?.click());
  expect(useShape.getState().view).toEqual({ kind: "mode", mode: 1 });
  await press("Swing");
  expect(useShape.getState().swinging).toBe(true);
});

it("shows the frequency of bowed struts beside that of straight ones, and what was left out", async () => {
  const shown = frameShown();
  const bowed = { share: 0.03, seed: 1, modes: [{ frequency_hz: 6.2, kind: "global" as const }], of_straight: 0.502 };
  const note = { code: "support-unused", count: 1, message: "no strut ends at the support at vertex 5", remedies: [] };
  ask.mockResolvedValue({ ...shown, result: { ...shown.result, bowed, notes: [note] } });
  at.show(<FrameSection />);
  await press("Compute");
  const table = at.host.querySelector('[aria-label="Results"]')?.textContent;
  expect(table).toContain("Where struts bow by 3.0 %6.2 Hz50 % of straight");
  expect(at.host.textContent).toContain("No strut ends at the support at vertex 5");
});

it("says that the design has changed since, and no more once that is undone", async () => {
  at.show(<FrameSection />);
  await press("Compute");
  act(() => useDesign.setState({ ...movedFrame(), version: 2 }));
  expect(at.host.textContent).toContain("changed since");
  expect(at.host.textContent).toContain("Changed since it was computed.");
  act(() => useDesign.setState({ ...smallFrame(), version: 3 }));
  expect(at.host.textContent?.toLowerCase()).not.toContain("changed since");
});

it("shows what is refused, with what to do", async () => {
  at.show(<FrameSection />);
  ask.mockRejectedValue(new Error("Material x has no shear modulus. Choose another material."));
  await press("Compute");
  expect(at.host.textContent).toContain("Material x has no shear modulus. Choose another material.");
  expect(useFrame.getState().asking).toBe(false);
});

it("puts a force on what is selected, lists it, and takes it away", async () => {
  at.show(<FrameSection />);
  openLoads();
  act(() => select([2]));
  await press("Put on selected");
  expect(at.host.querySelector('[aria-label="Forces"]')?.textContent).toContain("vertex 2z −1 N");
  const remove = at.host.querySelector<HTMLButtonElement>('[aria-label="Remove the force at vertex 2"]');
  act(() => remove?.click());
  expect(at.host.textContent).toContain("No forces at vertices.");
});

it("has presets of gravity, of which that of a file needs one", async () => {
  at.show(<FrameSection />);
  openLoads();
  const radio = (label: string) =>
    [...at.host.querySelectorAll<HTMLLabelElement>('[aria-label="Gravity"] label')]
      .find(({ textContent }) => textContent === label)
      ?.querySelector("input");
  act(() => radio("None")?.click());
  expect(useFrame.getState().gravity).toEqual([0, 0, 0]);
  expect(radio("Of the file")?.disabled).toBe(true);
  act(() => radio("Down")?.click());
  expect(useFrame.getState().gravity).toEqual([0, 0, -1]);
});

it("cancels at once, and says so", async () => {
  at.show(<FrameSection />);
  ask.mockReturnValue(new Promise(() => {}));
  await press("Compute");
  await press("Cancel");
  expect(ask).toHaveBeenLastCalledWith("stop-frame", {});
  expect(at.host.textContent).toContain("Cancelled.");
  expect(button("Compute")).toBeDefined();
});
