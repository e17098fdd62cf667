import { afterAll, beforeAll, expect, it } from "vitest";
import type { DesignView } from "../../../../ui/src/generated/responses.ts";
import { Editor, until } from "../../support/editor.ts";
import { type Place, Sight } from "../../support/sight.ts";

let editor: Editor;
let first: DesignView;
let sight: Sight;

beforeAll(async () => {
  editor = await Editor.open();
  await editor.take("house", "edit");
  first = await editor.design();
  sight = await Sight.from(
    editor.page,
    "front",
    first.vertices.map(({ at_mm }) => at_mm),
  );
});
afterAll(() => editor?.end());

const edit = () => editor.section("edit");
const selected = () => edit().locator("p[role=status]").innerText();
const press = (keys: string) => editor.page.keyboard.press(keys);
const size = async () => {
  const { vertices, edges } = await editor.design();
  return [vertices.length, edges.length];
};
/** What undo would take back. */
const last = async () => (await editor.design()).state.undo;

async function click(place: Place, options: { shift?: boolean; double?: boolean } = {}): Promise<void> {
  const { x, y } = sight.at(place);
  if (options.shift) await editor.page.keyboard.down("Shift");
  if (options.double) await editor.page.mouse.dblclick(x, y);
  else await editor.page.mouse.click(x, y);
  if (options.shift) await editor.page.keyboard.up("Shift");
}

async function drag(from: Place, to: Place): Promise<void> {
  const { mouse } = editor.page;
  const [a, b] = [sight.at(from), sight.at(to)];
  await mouse.move(a.x, a.y);
  await mouse.down();
  await mouse.move(b.x, b.y, { steps: 6 });
  await mouse.up();
}

/** Takes one change back, and waits until the window shows so. */
async function undo(expected: readonly number[]): Promise<void> {
  await press("Control+z");
  await until(size).toEqual(expected);
  await edit()
    .locator(".section-phrase", { hasText: `${expected[0]} vert` })
    .waitFor();
}

/** Where a person clicks on nothing. */
const NOWHERE: Place = [-60, 0, 80];
const HOUSE = [6, 6];
/** The ridge and the floor's right corner, as the file has them. */
const RIDGE: Place = [0, 0, 97.094474];
const CORNER: Place = [35, 0, 0];

it("selects by a click, with Shift more, in a box, and what is connected", async () => {
  await click(CORNER);
  await until(selected).toBe("1 vertex · 0 edges");
  await click([35, 0, 60], { shift: true });
  await until(selected).toBe("2 vertices · 1 edge · 60.0 mm");
  await click(NOWHERE);
  await until(selected).toMatch(/^Nothing selected/);
  await click([35, 0, 30]);
  await until(selected).toBe("2 vertices · 1 edge · 60.0 mm");
  await drag([-50, 0, 103], [10, 0, 50]);
  await until(selected).toBe("2 vertices · 1 edge · 51.0 mm");
  await click(RIDGE, { double: true });
  await until(selected).toBe("6 vertices · 6 edges · 292.0 mm");
  await press("Escape");
  await until(selected).toMatch(/^Nothing/);
});

it("drags a vertex in one step that undo takes back", async () => {
  await drag(CORNER, [45, 0, 0]);
  await until(async () => (await editor.vertex(1)).map(Math.round)).toEqual([45, 0, 0]);
  await press("Control+z");
  await until(() => editor.vertex(1)).toEqual(CORNER);
  expect(await last()).toBeNull();
});

it("moves by G, an axis and a typed distance", async () => {
  await click(CORNER);
  for (const key of ["g", "x", "1", "0", "Enter"]) await press(key);
  await until(() => editor.vertex(1)).toEqual([45, 0, 0]);
  await press("g");
  await press("z");
  await press("Escape");
  expect(await editor.vertex(1)).toEqual([45, 0, 0]);
  await press("Control+z");
  await until(() => editor.vertex(1)).toEqual(CORNER);
});

it("moves along the arrow of the gizmo alone", async () => {
  await click(CORNER);
  const { mouse } = editor.page;
  const { x, y } = sight.at(CORNER);
  // Half way along the arrow to the right.
  await mouse.move(x + 40, y);
  await mouse.down();
  await mouse.move(x + 140, y - 60, { steps: 6 });
  await mouse.up();
  await until(async () => (await editor.vertex(1))[0]).toBeGreaterThan(45);
  expect((await editor.vertex(1)).slice(1)).toEqual(CORNER.slice(1));
  await press("Control+z");
  await until(() => editor.vertex(1)).toEqual(CORNER);
});

it("takes what is typed into a cell, also in inches", async () => {
  const field = editor.page.getByRole("table", { name: "Vertices" }).getByLabel("Vertex 1, X, mm");
  await field.fill("2 in");
  await field.press("Enter");
  await until(() => editor.vertex(1)).toEqual([50.8, 0, 0]);
  await field.fill("many");
  await field.press("Enter");
  expect(await field.getAttribute("aria-invalid")).toBe("true");
  await field.press("Escape");
  await editor.page.locator(".viewport canvas").focus();
  await press("Control+z");
  await until(() => editor.vertex(1)).toEqual(CORNER);
});

it("deletes, splits, merges, connects", async () => {
  await click([35, 0, 30]);
  await press("x");
  await until(size).toEqual([6, 5]);
  await undo(HOUSE);
  await click([35, 0, 30]);
  await press("s");
  await until(size).toEqual([7, 7]);
  const added = (await editor.design()).vertices.at(-1);
  expect(added?.at_mm).toEqual([35, 0, 30]);
  await undo(HOUSE);
  await click([35, 0, 60]);
  await click([-35, 0, 60], { shift: true });
  await press("c");
  await until(size).toEqual([6, 7]);
  await press("m");
  await until(size).toEqual([5, 5]);
  expect((await editor.design()).vertices.map(({ at_mm }) => at_mm.join())).toContain("0,0,60");
  await undo([6, 7]);
  await undo(HOUSE);
});

it("copies and pastes beside, by the clipboard", async () => {
  await click([35, 0, 60]);
  await click(RIDGE, { shift: true });
  await press("Control+c");
  await press("Control+v");
  await until(size).toEqual([8, 7]);
  const { vertices } = await editor.design();
  // A step of the grid beside the first.
  expect(vertices.slice(-2).map(({ at_mm }) => at_mm)).toEqual(
    expect.arrayContaining([
      [40, 5, 60],
      [5, 5, 97.094474],
    ]),
  );
  await undo(HOUSE);
});

/** Opens an operation, sets its fields, and does it: with its button, where Enter in a field has not done it. */
async function operate(
  name: string,
  doing: string | RegExp | null,
  fields: Readonly<Record<string, string>> = {},
): Promise<void> {
  const form = editor.page.locator(`#operation-${name}`);
  if ((await form.getByRole("button", { expanded: true }).count()) === 0) await form.locator(".operation-head").click();
  for (const [label, value] of Object.entries(fields)) {
    const field = form.getByLabel(label).first();
    await field.fill(value);
    await field.press("Enter");
  }
  if (doing !== null) await form.locator(".operation-form").getByRole("button", { name: doing }).click();
}

it("mirrors, arrays, scales, straightens, rounds", async () => {
  await click(RIDGE, { double: true });
  await until(selected).toMatch(/^6 vertices/);
  await operate("array", /Make 2 copies/, { Copies: "2", "From copy to copy, X": "0", "From copy to copy, Y": "40" });
  await until(size).toEqual([18, 18]);
  const depths = new Set((await editor.design()).vertices.map(({ at_mm }) => at_mm[1]));
  expect([...depths].toSorted((a, b) => a - b)).toEqual([0, 40, 80]);
  await undo(HOUSE);

  await click([35, 0, 60]);
  await operate("mirror", "Mirror");
  await until(size).toEqual([7, 6]);
  expect((await editor.design()).vertices.at(-1)?.at_mm).toEqual([-35, 0, 60]);
  await undo(HOUSE);

  await click(RIDGE, { double: true });
  await until(selected).toMatch(/^6 vertices/);
  await operate("scale", null, { Factor: "2" });
  await until(selected).toBe("6 vertices · 6 edges · 584.0 mm");
  await press("Control+z");
  await until(selected).toBe("6 vertices · 6 edges · 292.0 mm");
  // The height is its largest side.
  await operate("scale", null, { Size: "194.188948" });
  await until(selected).toBe("6 vertices · 6 edges · 584.0 mm");
  await press("Control+z");
  await until(selected).toBe("6 vertices · 6 edges · 292.0 mm");

  // The two halves of the floor are one line.
  await click([20, 0, 0]);
  await click([-20, 0, 0], { shift: true });
  await operate("straighten", "Straighten");
  await until(size).toEqual([5, 5]);
  await undo(HOUSE);

  // Wall, roof, roof: no arc runs close to them, and one within 40 mm.
  await click([35, 0, 30]);
  await click([17, 0, 78.5], { shift: true });
  await click([-17, 0, 78.5], { shift: true });
  await until(selected).toMatch(/3 edges/);
  await operate("round", "Round", { Tolerance: "1" });
  await editor.messages.filter({ hasText: "No arc is that close to the chain" }).waitFor();
  await operate("round", "Round", { Tolerance: "40" });
  await until(async () => ((await size())[0] ?? 0) > 6).toBe(true);
  await undo(HOUSE);
  await press("Control+z");
  await until(last).toBeNull();
  await editor.isClean("edit");
});

it("does again what was undone, and undoes all the way back to what was opened", async () => {
  await click(CORNER);
  for (const key of ["g", "z", "-", "8", "Enter"]) await press(key);
  await until(() => editor.vertex(1)).toEqual([35, 0, -8]);
  await click([35, 0, 40]);
  await press("s");
  await until(size).toEqual([7, 7]);
  const then = await editor.design();
  await press("Control+z");
  await until(size).toEqual(HOUSE);
  await press("Control+z");
  await until(last).toBeNull();
  const { vertices, edges } = await editor.design();
  expect({ vertices, edges }).toEqual({ vertices: first.vertices, edges: first.edges });
  await press("Control+y");
  await until(size).toEqual(HOUSE);
  await press("Control+Shift+Z");
  await until(size).toEqual([7, 7]);
  expect((await editor.design()).vertices).toEqual(then.vertices);
});
