// @vitest-environment happy-dom
import { act } from "react";
import { expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { EditOutcome } from "../../generated/responses";
import { ShownUnit } from "../../shared/figures/unit";
import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { useOutcomes } from "../../state/design/outcomes";
import { select } from "../../state/design/selection";
import { designState } from "../../state/testing";
import { FilletForm } from "./Fillet";

const at = place();

const found: EditOutcome = {
  outcome: "no-fillet",
  part: "edges",
  vertex: 1,
  length_mm: 3,
  needed_mm: 20.4,
  nearest_mm: 12.5,
};

function corners(): void {
  const corner = { support: false };
  useDesign.setState({
    state: designState(),
    vertices: new Map([
      [0, { id: 0, at: [0, 0, 0], ...corner }],
      [1, { id: 1, at: [50, 0, 0], ...corner }],
      [2, { id: 2, at: [50, 50, 0], ...corner }],
    ]),
    edges: new Map([
      [0, { id: 0, a: 0, b: 1 }],
      [1, { id: 1, a: 1, b: 2 }],
    ]),
  });
  act(() => select([1]));
}

it("names a radius in inches that fits, on whichever side of what was asked it is", async () => {
  // 0.4996 in, which would be rounded to 0.500, and 1.5752 in, which would be rounded to 1.575.
  for (const [nearest_mm, said] of [
    [12.69, "0.499 in"],
    [12.6, "0.496 in"],
    [40.01, "1.576 in"],
    [40.3, "1.587 in"],
  ] as const) {
    platform.ask.mockImplementation(async () => ({ outcome: { ...found, nearest_mm } }));
    corners();
    at.show(
      <ShownUnit value="inch">
        <FilletForm key={nearest_mm} />
      </ShownUnit>,
    );
    await act(async () => {});
    expect(at.host.textContent).toContain(`The nearest radius that fits is ${said}.`);
    act(() => useOutcomes.setState({ fillet: null }));
  }
});

it("is not offered where it would be refused, and says beside the button what fits", async () => {
  platform.ask.mockImplementation(async (name: string) => (name === "outcome" ? { outcome: found } : {}));
  corners();
  at.show(<FilletForm />);
  await act(async () => {});
  const button = [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Fillet");
  expect(button?.getAttribute("aria-disabled")).toBe("true");
  expect(at.host.textContent).toContain("The nearest radius that fits is 12.5 mm.");
  act(() => button?.click());
  const field = at.host.querySelector("input");
  act(() => void field?.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true })));
  expect(platform.ask).not.toHaveBeenCalledWith("edit", expect.anything());
});
