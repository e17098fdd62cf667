// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import { useView } from "../../state/window/view";
import { ViewCube } from "./ViewCube";

const at = place();
afterEach(() => useView.setState({ tool: "select", plane: "xy", strand: null }));

const off = () =>
  [...at.host.querySelectorAll('button[aria-disabled="true"]')].map(({ lastChild }) => lastChild?.textContent);

it("keeps the sides off that would show the plane of an open strand from its edge, also once that is another plane", () => {
  useView.setState({ tool: "draw", plane: "xy", strand: 1 });
  at.show(<ViewCube />);
  expect(off()).toEqual(["Front", "Back", "Right", "Left"]);
  act(() => useView.setState({ plane: "xz" }));
  expect(off()).toEqual(["Right", "Left", "Top", "Bottom"]);
});
