// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { select } from "../../state/design/selection";
import { designState } from "../../state/testing";
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

/** A typed place along one axis, as it is committed. */
const type = (axis: string, text: string) =>
  act(() => {
    const field = at.host.querySelector<HTMLInputElement>(`[aria-label^="Vertex 1, ${axis}"]`);
    if (!field) throw new Error(`no field for ${axis}`);
    const set = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set;
    field.focus();
    set?.call(field, text);
    field.dispatchEvent(new Event("input", { bubbles: true }));
    field.blur();
  });

it("keeps what was typed along one axis while another one is typed", async () => {
  act(() => select([1]));
  const answers: (() => void)[] = [];
  platform.ask.mockImplementation(
    (_: string, { request }: { request: { positions: { at_mm: [number, number, number] }[] } }) =>
      new Promise((done) => {
        const [{ at_mm = [0, 0, 0] } = {}] = request.positions;
        const change = {
          vertices: [{ id: 1, at_mm, support: false }],
          edges: [],
          gone_vertices: [],
          gone_edges: [],
          state: designState(),
        };
        answers.push(() => done({ change, notes: [] }));
      }),
  );
  type("X", "7");
  type("Y", "8");
  for (const count of [1, 2]) {
    await vi.waitFor(() => expect(answers).toHaveLength(count));
    await act(async () => answers[count - 1]?.());
  }
  await vi.waitFor(() => expect(useDesign.getState().vertices.get(1)?.at).toEqual([7, 8, 0]));
});
