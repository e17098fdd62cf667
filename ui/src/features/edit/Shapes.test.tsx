// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { EditRequest } from "../../generated/requests";
import type { Vec3 } from "../../scene/interface";
import { place } from "../../shared/testing";
import { useProblems } from "../../state/asking/problems";
import { useDesign } from "../../state/design/design";
import { select } from "../../state/design/selection";
import { designState } from "../../state/testing";
import { choosePlane, putPlane, useView } from "../../state/window/view";
import { Shapes } from "./Shapes";

const at = place();

/** Vertices 1, 2 and 3: the plane through them is upright, 3-4-5 in x and y, and does not go through the origin. */
const POINTS: readonly [Vec3, Vec3, Vec3] = [
  [10, 0, 5],
  [40, 40, 5],
  [10, 0, 65],
];

beforeEach(() => {
  platform.ask.mockReset();
  platform.ask.mockImplementation(async (ask: string) =>
    ask === "outcome"
      ? { outcome: { outcome: "shape", edges: 12, length_mm: 26, needed_mm: 0, fits: true, fitting: 12 } }
      : { change: null, notes: [] },
  );
  useProblems.setState({ problems: [] });
  useDesign.setState({
    state: designState(),
    vertices: new Map(POINTS.map((place, k) => [k + 1, { id: k + 1, at: place, support: false }])),
    edges: new Map(),
  });
  useView.setState({ plane: "xy", ownPlane: null, planeOffset: 0 });
  select([1, 2, 3]);
});

const planes = () => at.host.querySelector('[aria-label="Plane of the shape"]') as HTMLElement;
const choices = () => [...planes().querySelectorAll("label")].map(({ textContent }) => textContent);
const chosen = () => planes().querySelector<HTMLInputElement>("input:checked")?.value;
const choose = (value: string) => act(() => planes().querySelector<HTMLInputElement>(`[value="${value}"]`)?.click());
const settled = () => act(() => new Promise((resolve) => setTimeout(resolve)));
const pressed = (name: string) =>
  act(async () => {
    [...at.host.querySelectorAll<HTMLElement>("button, label")]
      .find(({ textContent }) => textContent === name)
      ?.click();
    await new Promise((resolve) => setTimeout(resolve));
  });
const edits = () =>
  platform.ask.mock.calls.flatMap(([ask, { request }]) => (ask === "edit" ? [request as EditRequest] : []));

it("offers the plane on three points only where there is one, and then it is the one that is chosen", async () => {
  at.show(<Shapes />);
  expect([choices(), chosen()]).toEqual([["XY", "XZ", "YZ"], "xy"]);
  act(putPlane);
  expect([choices(), chosen()]).toEqual([["XY", "XZ", "YZ", "Points"], "points"]);
  act(() => choosePlane("yz"));
  expect([choices(), chosen()]).toEqual([["XY", "XZ", "YZ"], "yz"]);
  await settled();
});

it("leaves the plane that is drawn on as it is, whichever is chosen for a shape", async () => {
  putPlane();
  at.show(<Shapes />);
  const { ownPlane } = useView.getState();
  choose("xz");
  expect(chosen()).toBe("xz");
  expect(useView.getState()).toMatchObject({ ownPlane, plane: "xy" });
  await pressed("Add circle");
  expect(edits()).toMatchObject([{ edit: "circle", plane: "xz", centre_mm: [0, 0, 0] }]);
});

it("adds no shape that cannot be, with the reason that is shown", async () => {
  platform.ask.mockImplementation(async (ask: string) => {
    if (ask === "outcome") throw new Error("a radius has to be more than 0");
    return { change: null, notes: [] };
  });
  at.show(<Shapes />);
  const button = () => [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Add circle");
  await vi.waitFor(() => expect(button()?.title).toBe("a radius has to be more than 0"));
  expect(at.host.querySelector("output")?.textContent).toContain("a radius has to be more than 0");
  await pressed("Add circle");
  expect(edits()).toEqual([]);
});

it("lays a shape on the three points, from the first of them, with the offset", async () => {
  putPlane();
  useView.setState({ planeOffset: 7 });
  at.show(<Shapes />);
  await pressed("Helix");
  await pressed("Add helix");
  const [edit, ...others] = edits();
  expect(others).toEqual([]);
  if (edit?.edit !== "helix" || !edit.on) throw new Error("it lies on a plane of the axes");
  expect(edit.centre_mm).toEqual([0, 0, 0]);
  const { origin_mm, u, v } = edit.on;
  // 3-4-5 towards the second, up towards the third, and off the plane.
  [0.6, 0.8, 0].forEach((part, k) => expect(u[k]).toBeCloseTo(part, 9));
  [0, 0, 1].forEach((part, k) => expect(v[k]).toBeCloseTo(part, 9));
  [10 + 7 * 0.8, -7 * 0.6, 5].forEach((mm, k) => expect(origin_mm[k]).toBeCloseTo(mm, 9));
});
