import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";
import { type Place, Sight } from "../../support/sight.ts";
import { atRest } from "../../support/still.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const press = (keys: string) => editor.page.keyboard.press(keys);
const said = () => editor.page.locator(".measuring").innerText();
const written = (text: string) => editor.page.locator(".viewport").getByText(text, { exact: true });

/** A strand in the plane y = 0, as high as the view frames by its height. */
const STRAND: readonly Place[] = [
  [0, 0, 0],
  [60, 0, 0],
  [60, 0, 80],
  [90, 0, 80],
];
let sight: Sight;

async function click(place: Place): Promise<void> {
  const { x, y } = sight.at(place);
  await editor.page.mouse.move(x - 3, y);
  await editor.page.mouse.move(x, y);
  await editor.page.locator(".hover-card").waitFor();
  await editor.page.mouse.click(x, y);
}

it("measures between vertices, edges, their middles and construction lines, and changes nothing", async () => {
  await editor.loopback.ask("new", {});
  await editor.loopback.ask("edit", { request: { edit: "draw", through_mm: STRAND.map((at) => [...at]) } });
  await editor.reload("edit");
  sight = await Sight.from(editor.page, "front", STRAND);
  // The last edge becomes a construction line.
  const { x, y } = sight.at([75, 0, 80]);
  await editor.page.mouse.click(x, y);
  await press("k");
  await until(async () => (await editor.design()).edges.length).toBe(2);
  const { state } = await editor.design();
  await press("u");
  await until(said).toMatch(/^Click what to measure from/);

  // From an edge to a line that is parallel to it, 80 mm above and beside it; √(60² + 80²) from corner to corner.
  for (const [one, other, text, label] of [
    [[20, 0, 0], [82, 0, 80], "Distance 80.0 mm · x 0.0  y 0.0  z 80.0 mm · 0.0°", "80.0 mm"],
    [[0, 0, 0], [60, 0, 80], "Distance 100.0 mm · x 60.0  y 0.0  z 80.0 mm", "100.0 mm"],
    // The middle of an edge, and across from it: √(30² + 80²).
    [[30, 0, 0], [60, 0, 80], "Distance 85.4 mm · x 30.0  y 0.0  z 80.0 mm", "85.4 mm"],
    [[60, 0, 20], [75, 0, 80], "Distance 15.0 mm · x 15.0  y 0.0  z 0.0 mm", "15.0 mm"],
    [[60, 0, 20], [20, 0, 0], "Distance 0.0 mm · x 0.0  y 0.0  z 0.0 mm · 90.0°", "0.0 mm"],
  ] as const) {
    await click(one);
    await until(said).toBe("Click what to measure to.");
    await click(other);
    await until(said).toBe(text);
    await written(label).first().waitFor();
  }
  await editor.isClean("measure");
  await press("Escape");
  await until(said).toMatch(/^Click what to measure from/);
  const after = await editor.design();
  expect([after.state.undo, after.edges.length]).toEqual([state.undo, 2]);
  await press("q");
  await editor.page.locator(".measuring").waitFor({ state: "detached" });
});

/** A plate of 60 mm by 80 mm in the plane y = 0, as STL. */
const PLATE: readonly Place[] = [
  [0, 0, 0],
  [60, 0, 0],
  [60, 0, 80],
  [0, 0, 80],
];
const plate = () => {
  const facets = [
    [0, 1, 2],
    [0, 2, 3],
  ].map(
    (corners) =>
      `facet normal 0 -1 0\nouter loop\n${corners.map((corner) => `vertex ${PLATE[corner]?.join(" ")}\n`).join("")}endloop\nendfacet\n`,
  );
  return `solid plate\n${facets.join("")}endsolid plate\n`;
};

it("measures to corners and places of the stencil, in the unit that is shown", async () => {
  await editor.loopback.ask("new", {});
  await editor.reload("trace");
  await editor.drop("plate.stl", plate());
  const dialog = editor.page.getByRole("dialog", { name: "Open plate.stl" });
  await dialog.getByLabel("Unit").selectOption("mm");
  await dialog.getByRole("button", { name: "Open" }).click();
  await editor.section("trace").getByText("2 faces").first().waitFor();
  // The view has it a moment later: what it frames before is nothing.
  await atRest(editor.page);
  sight = await Sight.from(editor.page, "front", PLATE);
  await press("u");
  await click([0, 0, 0]);
  // To a place that is no corner: as far as a pixel is exact.
  const { x, y } = sight.at([30, 0, 40]);
  await editor.page.mouse.move(x, y);
  await until(said).toMatch(/^Distance/);
  expect(Math.abs(Number.parseFloat((await said()).slice("Distance ".length)) - 50)).toBeLessThan(sight.pixel);
  await click([60, 0, 80]);
  await until(said).toBe("Distance 100.0 mm · x 60.0  y 0.0  z 80.0 mm");
  await editor.menu("View", "Lengths", "Inches");
  // 100 mm and 60 mm over 25.4.
  await until(said).toBe("Distance 3.937 in · x 2.362  y 0.000  z 3.150 in");
  await editor.isClean("measure-stencil");
  await editor.menu("View", "Lengths", "Millimetres");
});
