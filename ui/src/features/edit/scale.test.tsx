// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { select } from "../../state/design/selection";
import { ScaleForm } from "./copies";

const at = place();

beforeEach(() => {
  platform.ask.mockReset().mockReturnValue(new Promise(() => {}));
});

const press = (on: Element, init: KeyboardEventInit) =>
  act(() => void on.dispatchEvent(new KeyboardEvent("keydown", { bubbles: true, cancelable: true, ...init })));

/** Two vertices are selected, 2 mm apart along x. */
function showOfTwo(): void {
  useDesign.setState({
    vertices: new Map([
      [3, { id: 3, at: [0, 0, 1], support: false }],
      [5, { id: 5, at: [2, 1, 1], support: false }],
    ]),
  });
  act(() => select([3, 5]));
  at.show(<ScaleForm />);
}

it("a size and a factor of nothing are refused in the same words", () => {
  showOfTwo();
  for (const field of at.host.querySelectorAll<HTMLInputElement>("input[inputmode=decimal]")) {
    act(() => {
      Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, "0");
      field.dispatchEvent(new Event("input", { bubbles: true }));
    });
  }
  const said = [...at.host.querySelectorAll("[role=alert]")].map(({ textContent }) => textContent);
  expect(said).toEqual(["Expected more than 0 mm", "Expected more than 0, at most 10\u202f000"]);
});

it("the selection is scaled by Enter, to the size that was just typed along its largest side", async () => {
  showOfTwo();
  const [size] = at.host.querySelectorAll("input");
  if (!size) throw new Error("no field");
  press(size, { key: "Enter" });
  expect(platform.ask).not.toHaveBeenCalledWith("edit", expect.anything());
  act(() => {
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(size, "10");
    size.dispatchEvent(new Event("input", { bubbles: true }));
  });
  press(size, { key: "Enter" });
  await act(async () => {});
  const edits = platform.ask.mock.calls.filter(([name]) => name === "edit").map(([, { request }]) => request);
  // Five times as large, from 2 mm to 10 mm along X, about the middle of the selection.
  expect(edits).toEqual([
    {
      edit: "transform",
      lines: [],
      vertices: [3, 5],
      matrix: [
        [5, 0, 0, -4],
        [0, 5, 0, -2],
        [0, 0, 5, -4],
        [0, 0, 0, 1],
      ],
    },
  ]);
});
