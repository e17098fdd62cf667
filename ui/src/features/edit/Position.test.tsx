// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { select } from "../../state/design/selection";
import { Position } from "./Position";

const at = place();

beforeEach(() => {
  const joint = { kind: "solder", mass_g: 2 } as const;
  useDesign.setState({
    vertices: new Map([[1, { id: 1, at: [0, 0, 0], support: false, joint }]]),
    edges: new Map(),
  });
  select([]);
  at.show(<Position />);
});

const joint = () => at.host.querySelector('[aria-label="Joint"]') as HTMLSelectElement;
const moves = () => [...at.host.querySelectorAll("button")].filter(({ textContent }) => textContent === "Move");

it("gives no joint to nothing, and says why", () => {
  expect([joint().disabled, joint().title]).toEqual([true, "Nothing is selected."]);
  act(() => select([1]));
  expect([joint().disabled, joint().title]).toEqual([false, ""]);
});

it("has the mass of a joint with its unit behind the number", () => {
  act(() => select([1]));
  const mass = at.host.querySelector('[aria-label="Mass of the joint, g"]');
  expect(mass?.nextElementSibling?.textContent).toBe("g");
});

it("has a button to move several, and none beside the place of one, which moves as it is typed", () => {
  expect(moves()).toHaveLength(1);
  act(() => select([1]));
  expect(moves()).toHaveLength(0);
});
