import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";
import { type Place, Sight } from "../../support/sight.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

/** A plate that leans back, from 0 to 60 mm along x and 80 mm up, as STL. */
const PLATE: readonly Place[] = [
  [0, 0, 0],
  [60, 0, 0],
  [60, 40, 80],
  [0, 40, 80],
];
const plate = () => {
  const corners = (facet: readonly number[]) => facet.map((at) => `vertex ${PLATE[at]?.join(" ")}\n`).join("");
  const facets = [
    [0, 1, 2],
    [0, 2, 3],
  ].map((facet) => `facet normal 0 -2 1\nouter loop\n${corners(facet)}endloop\nendfacet\n`);
  return `solid plate\n${facets.join("")}endsolid plate\n`;
};

const press = (...keys: readonly string[]) => editor.keys(...keys);
const lines = async () => (await editor.design()).state.construction_mm;
const parts = () => editor.section("parts");
const row = (name: string) => parts().getByRole("button", { name: new RegExp(`^${name}`) });
const selected = () => editor.section("edit").locator(".selected").innerText();
let sight: Sight;
/** Looks from the front at all that there is: at the outermost places of it. */
const look = async (...places: readonly Place[]) => {
  sight = await Sight.from(editor.page, "front", places);
};
const move = async (place: Place) => {
  const { x, y } = sight.at(place);
  await editor.page.mouse.move(x - 3, y);
  await editor.page.mouse.move(x, y);
};
const click = async (place: Place) => {
  await move(place);
  const { x, y } = sight.at(place);
  await editor.page.mouse.click(x, y);
};

it("draws a construction line by a typed length and angle, and no edge", async () => {
  await editor.loopback.ask("new", {});
  await editor.reload("trace", "parts", "edit");
  await editor.drop("plate.stl", plate());
  const dialog = editor.page.getByRole("dialog", { name: "Open plate.stl" });
  await dialog.getByLabel("Unit").selectOption("mm");
  await dialog.getByRole("button", { name: "Open" }).click();
  await editor.section("trace").getByText("2 faces").first().waitFor();
  // It gives the focus back as it closes.
  await dialog.waitFor({ state: "hidden" });
  await editor.page.locator(".viewport canvas").focus();
  await press("Shift+K");
  await until(() =>
    editor
      .section("trace")
      .getByRole("checkbox", { name: /^Construction line:/ })
      .isChecked(),
  ).toBe(true);
  await look(...PLATE);
  await click([-10, 0, 10]);
  await move([0, 0, 50]);
  await editor.page.getByText(/construction line .* Tab: angle/).waitFor();
  await editor.isClean("construction-drawing");
  await press("6", "0", "Tab", "9", "0", "Enter");
  await until(lines).toEqual([[[-10, 0, 10].map(near), [-10, 0, 70].map(near)]]);
  await press("Escape", "Shift+K");
  await until(async () => (await editor.design()).state.undo).toBe("construction line");
  const { vertices, edges } = await editor.design();
  expect([vertices, edges]).toEqual([[], []]);
});

const near = (mm: number) => expect.closeTo(mm, 6);

it("is selected by a click, moved by a typed figure and mirrored, each as one thing to undo", async () => {
  await press("q");
  await look([-10, 0, 0], ...PLATE);
  await move([-10, 0, 25]);
  await editor.page.locator(".hover-card", { hasText: "Construction line 1 · 60.0 mm" }).waitFor();
  await click([-10, 0, 25]);
  await until(selected).toBe("1 construction line · 60.0 mm");
  await until(() => row("Line 1").getAttribute("aria-pressed")).toBe("true");
  await editor.isClean("construction-selected");
  await press("g", "x", "-", "1", "5", "Enter");
  await until(lines).toEqual([[[-25, 0, 10].map(near), [-25, 0, 70].map(near)]]);
  expect((await editor.design()).state.undo).toBe("move construction line");
  await until(selected).toBe("1 construction line · 60.0 mm");
  await editor.menu("Edit", "Mirror…");
  await editor.section("edit").getByRole("button", { name: "Mirror", exact: true }).last().click();
  await until(async () => (await lines()).length).toBe(2);
  await until(() => row("Line 2").getAttribute("aria-pressed")).toBe("true");
  expect((await lines())[1]).toEqual([[25, 0, 10].map(near), [25, 0, 70].map(near)]);
  await editor.page.locator(".viewport canvas").focus();
  await press("Control+z");
  await until(async () => (await lines()).length).toBe(1);
  await press("Escape");
});

it("is hidden and shown again by the eye in Parts", async () => {
  await row("Line 1").click();
  await parts().getByRole("button", { name: "Hide construction lines" }).click();
  await until(selected).toMatch(/^Nothing selected/);
  await look(...PLATE);
  await editor.isCleanNow("construction-hidden");
  await parts().getByRole("button", { name: "Show construction lines" }).click();
  await look([-25, 0, 0], ...PLATE);
  await click([-25, 0, 30]);
  await until(selected).toBe("1 construction line · 60.0 mm");
});

it("gives a plane two of its three points, a corner of the stencil the third, and the plane is drawn on", async () => {
  await editor.section("trace").getByRole("radio", { name: "Points" }).check({ force: true });
  const said = editor.page.locator(".measuring");
  await said.getByText("Click the first point").waitFor();
  await look([-25, 0, 0], ...PLATE);
  await click([-25, 0, 10]);
  await said.getByText("Click the second point").waitFor();
  await click([0, 40, 80]);
  await said.getByText("Click the third point").waitFor();
  await move([-25, 0, 70]);
  await editor.isClean("construction-plane");
  await click([-25, 0, 70]);
  await editor.section("trace").getByText("Through three points.").waitFor();
  await look([-25, 0, 0], ...PLATE);
  await click([-25, 0, 10]);
  await move([-10, 0, 40]);
  await press("5", "0", "Tab", "0", "Enter");
  // 50 mm from the first point towards the corner, which is 25, 40 and 70 mm away: √(25² + 40² + 70²) = 84.4 mm.
  const share = 50 / Math.hypot(25, 40, 70);
  await until(async () => (await editor.design()).vertices.map(({ at_mm }) => at_mm)).toEqual([
    [-25, 0, 10].map(near),
    [-25 + 25 * share, 40 * share, 10 + 70 * share].map(near),
  ]);
  await editor.isCleanNow("construction-plane-drawn");
  await press("Escape");
});
