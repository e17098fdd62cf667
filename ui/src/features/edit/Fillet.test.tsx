// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, expect, it, vi } from "vitest";

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
afterEach(() => {
  platform.ask.mockReset();
  useOutcomes.setState({ fillet: null });
});

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

/** Types into the field of the radius. */
async function type(text: string): Promise<void> {
  const field = at.host.querySelector("input");
  await act(async () => {
    const { set } = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value") ?? {};
    set?.call(field, text);
    field?.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await settled();
}

/** Until what was asked is answered, and what follows from it is asked and answered too. */
const settled = () => act(() => new Promise((resolve) => setTimeout(resolve, 20)));

const radius = () => at.host.querySelector("input")?.value;
const buttonOf = (name: string) =>
  [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === name);

/** The machine makes no radius below 36.3 mm, and warns of none from there. */
const machine = (request: { readonly request: { readonly radius_mm: number } }): EditOutcome =>
  request.request.radius_mm < 36.3
    ? { ...found, part: "chords", nearest_mm: 36.3 }
    : { outcome: "fillet", chords: [2], shortest_mm: 27.8, needed_mm: 25.8, clear_mm: request.request.radius_mm };

it("proposes a radius that the machine bends without a warning, and leaves one that a person has typed", async () => {
  platform.ask.mockImplementation(async (_name: string, request) => ({ outcome: machine(request) }));
  corners();
  at.show(<FilletForm />);
  await settled();
  expect(radius()).toBe("36.3");
  await settled();
  expect(at.host.textContent).toContain("2 chords on 1 corner, the shortest 27.8 mm");
  expect(at.host.querySelector(".wrong")).toBeNull();
  await type("12");
  expect(at.host.textContent).toContain("The nearest radius that fits is 36.3 mm.");
  expect(radius()).toBe("12");
});

it("says in the form what is too short, by how much, and offers the radius", async () => {
  platform.ask.mockImplementation(async (_name: string, request) => ({ outcome: machine(request) }));
  corners();
  at.show(<FilletForm />);
  await type("10");
  expect(at.host.querySelector(".wrong")?.textContent).toContain(
    "Two chords at vertex 1 would be 3.0 mm; the machine needs 20.4 mm.",
  );
  await act(async () => buttonOf("Use 36.3 mm")?.click());
  await settled();
  expect([radius(), at.host.querySelector(".wrong")]).toEqual(["36.3", null]);
});

it("names the radius of which Check does not warn beside one of which it does", async () => {
  const near: EditOutcome = { outcome: "fillet", chords: [2], shortest_mm: 26, needed_mm: 25.8, clear_mm: 36.3 };
  platform.ask.mockImplementation(async () => ({ outcome: near }));
  corners();
  at.show(<FilletForm />);
  await type("34");
  expect(at.host.textContent).toContain("Check warns of a length near a limit.");
  expect(buttonOf("Use 36.3 mm")).toBeDefined();
  expect(buttonOf("Fillet")?.getAttribute("aria-disabled")).not.toBe("true");
});

it("is over once the corners are rounded, and begins again with others or when that is undone", async () => {
  const { version } = useDesign.getState();
  platform.ask.mockImplementation(async (name: string, request) =>
    name === "outcome"
      ? { outcome: useDesign.getState().version === version + 1 ? machine(request) : found }
      : {
          change: { state: useDesign.getState().state, vertices: [], edges: [], gone_vertices: [], gone_edges: [] },
          notes: [],
        },
  );
  corners();
  useDesign.setState({ version: version + 1 });
  at.show(<FilletForm />);
  await type("40");
  await act(async () => buttonOf("Fillet")?.click());
  await settled();
  expect(at.host.textContent).toContain("Done. Select the next corners.");
  await settled();
  // The corners of the arc are selected still, and no fillet of 40 mm fits there.
  expect(at.host.querySelector(".wrong")).toBeNull();
  expect(buttonOf("Fillet")?.getAttribute("aria-disabled")).toBe("true");
  await act(async () => useDesign.setState({ version: version + 1 }));
  await settled();
  expect(at.host.textContent).toContain("2 chords on 1 corner");
  expect(buttonOf("Fillet")?.getAttribute("aria-disabled")).not.toBe("true");
});

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
    await settled();
    await type("30 mm");
    expect(at.host.textContent).toContain(`The nearest radius that fits is ${said}.`);
    act(() => useOutcomes.setState({ fillet: null }));
  }
});

it("is not offered where it would be refused, and says beside the button what fits", async () => {
  platform.ask.mockImplementation(async (name: string) => (name === "outcome" ? { outcome: found } : {}));
  corners();
  at.show(<FilletForm />);
  await settled();
  await type("3");
  const button = [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Fillet");
  expect(button?.getAttribute("aria-disabled")).toBe("true");
  expect(at.host.textContent).toContain("The nearest radius that fits is 12.5 mm.");
  act(() => button?.click());
  const field = at.host.querySelector("input");
  act(() => void field?.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true })));
  expect(platform.ask).not.toHaveBeenCalledWith("edit", expect.anything());
});
