import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";
import { type Place, Sight } from "../../support/sight.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const press = (keys: string) => editor.page.keyboard.press(keys);
const edit = () => editor.section("edit");

/** A strand in the plane y = 0, as a person would have drawn it; as high as the view frames by its height. */
const STRAND: readonly Place[] = [
  [0, 0, 0],
  [60, 0, 0],
  [60, 0, 80],
  [90, 0, 80],
];
let sight: Sight;

async function click(place: Place, shift = false): Promise<void> {
  const { x, y } = sight.at(place);
  if (shift) await editor.page.keyboard.down("Shift");
  await editor.page.mouse.click(x, y);
  if (shift) await editor.page.keyboard.up("Shift");
}

async function type(label: string, text: string): Promise<void> {
  const field = edit().getByLabel(label);
  await field.fill(text);
  await field.press("Enter");
}

const apart = async (a: number, b: number) => {
  const [from, to] = [await editor.vertex(a), await editor.vertex(b)];
  return Math.hypot(...from.map((value, k) => value - (to[k] ?? NaN)));
};
/** What is written in the view. */
const written = (text: string) => editor.page.locator(".viewport").getByText(text, { exact: true });

it("takes a length and an angle that are typed, in one step each", async () => {
  await editor.loopback.ask("new", {});
  await editor.loopback.ask("edit", { request: { edit: "draw", through_mm: STRAND.map((at) => [...at]) } });
  await editor.reload("edit");
  await edit().locator(".section-phrase", { hasText: "4 vert" }).waitFor();
  sight = await Sight.from(editor.page, "front", STRAND);
  await click([60, 0, 20]);
  await written("80.0 mm").waitFor();
  await written("stays").waitFor();
  expect(await edit().getByLabel("Length of the edge, mm").inputValue()).toBe("80.0");
  await editor.isClean("exact-length");
  await type("Length of the edge, mm", "50");
  await until(() => apart(1, 2)).toBeCloseTo(50, 9);
  // The first vertex stays, and the rest goes along.
  expect([await editor.vertex(1), await editor.vertex(3)]).toEqual([
    [60, 0, 0],
    [90, 0, 50],
  ]);
  await editor.page.locator(".viewport canvas").focus();
  await press("Control+z");
  await until(() => editor.vertex(3)).toEqual(STRAND[3]);
  // The window shows it, too: the corner is clicked on where it is now.
  await written("80.0 mm").waitFor();

  await click([60, 0, 80]);
  await written("90.0°").waitFor();
  await editor.isCleanNow("exact-angle");
  await type("Angle between the edges, °", "135");
  await until(async () => (await editor.vertex(3)).map((value) => Math.round(value * 1e6) / 1e6)).toEqual([
    60 + Math.round(30e6 * Math.SQRT1_2) / 1e6,
    0,
    80 + Math.round(30e6 * Math.SQRT1_2) / 1e6,
  ]);
  expect((await editor.design()).state.undo).toBe("set angle");
  await editor.page.locator(".viewport canvas").focus();
  await press("Control+z");
  await until(() => editor.vertex(3)).toEqual(STRAND[3]);
});

it("says what is not possible, and what is", async () => {
  await click([60, 0, 20]);
  await type("Length of the edge, mm", "0");
  await editor.messages
    .filter({ hasText: "0 mm is no length of an edge: it has to be more than 0" })
    .filter({ hasText: "Type a length of more than 0." })
    .waitFor();
  expect((await editor.design()).state.undo).toBe("draw");
});

it("measures between two things that are selected", async () => {
  await click([0, 0, 0]);
  await click([60, 0, 80], true);
  await edit().getByText("Distance 100.0 mm · x 60.0  y 0.0  z 80.0 mm").waitFor();
  await written("100.0 mm").waitFor();
  await editor.isClean("measure");
  await click([90, 0, 80]);
  await click([30, 0, 0], true);
  await edit().getByText("Distance 85.4 mm").waitFor();
});

it("turns the selection by a typed angle", async () => {
  await editor.page.locator(".viewport canvas").focus();
  await press("a");
  await press("r");
  const form = edit().locator("#operation-rotate");
  await form.getByText("Y", { exact: true }).click();
  await form.getByText("Origin", { exact: true }).click();
  await form.getByLabel("Angle").fill("90");
  await form.getByLabel("Angle").press("Enter");
  // Right-handed about y: x goes to -z, z to x.
  await until(() => editor.vertex(3)).toEqual([80, 0, -90]);
  expect((await editor.design()).state.undo).toBe("rotate 4 vertices");
});

it("turns the selection about an edge that was selected before", async () => {
  await editor.page.locator(".viewport canvas").focus();
  await press("Control+z");
  await until(() => editor.vertex(3)).toEqual(STRAND[3]);
  await press("Escape");
  const form = edit().locator("#operation-rotate");
  const edge = form.getByText("Edge", { exact: true });
  expect(await form.getByTitle("Select the edge to turn about first.").count()).toBe(1);
  await click([60, 0, 20]);
  await edge.click();
  await form.getByRole("button", { name: "From vertex 1 to 2" }).waitFor();
  await editor.isClean("rotate-edge");
  await click([90, 0, 80]);
  await form.getByLabel("Angle").fill("90");
  await form.getByLabel("Angle").press("Enter");
  // About the upright edge at x = 60, right-handed upwards: x goes to y.
  await until(() => editor.vertex(3)).toEqual([60, 30, 80]);
  await editor.page.locator(".viewport canvas").focus();
  await press("Control+z");
  await until(() => editor.vertex(3)).toEqual(STRAND[3]);
  // As it was before.
  await form.getByText("Y", { exact: true }).click();
});

it("adds a circle, a polygon and a helix from figures", async () => {
  const shapes = edit().getByRole("group", { name: "Shapes" });
  const size = async () => {
    const { vertices, edges } = await editor.design();
    return [vertices.length, edges.length];
  };
  await shapes.getByRole("button", { name: "Add circle" }).click();
  await until(size).toEqual([16, 15]);
  await shapes.getByText("Polygon", { exact: true }).click();
  await shapes.getByLabel("Sides").fill("6");
  await shapes.getByRole("button", { name: "Add polygon" }).click();
  await until(size).toEqual([22, 21]);
  await shapes.getByText("Helix", { exact: true }).click();
  await editor.isCleanNow("shapes");
  await shapes.getByRole("button", { name: "Add helix" }).click();
  // Three turns of six edges.
  await until(size).toEqual([41, 39]);
  expect((await editor.design()).state.undo).toBe("helix");
});

it("turns what is selected with an arc of the gizmo, by steps of 15° or by a typed angle", async () => {
  await editor.loopback.ask("new", {});
  await editor.loopback.ask("edit", { request: { edit: "draw", through_mm: STRAND.map((at) => [...at]) } });
  await editor.reload("edit");
  await edit().locator(".section-phrase", { hasText: "4 vert" }).waitFor();
  sight = await Sight.from(editor.page, "front", STRAND);
  await press("a");
  await edit().locator("p[role=status]").getByText("4 vertices").waitFor();
  const { mouse } = editor.page;
  // The mean of the vertices, and 52 px from it halfway between the arrows of x and z.
  const { x, y } = sight.at([52.5, 0, 40]);
  const beside = 52 * Math.SQRT1_2;
  await mouse.move(x + beside, y - beside);
  await editor.isCleanNow("gizmo-arcs");
  await mouse.down();
  await mouse.move(x + 60, y - 2, { steps: 4 });
  await editor.page.getByText("about y 45.0°").waitFor();
  await editor.isCleanNow("gizmo-turning");
  await mouse.move(x + beside, y + beside, { steps: 4 });
  await editor.page.getByText("about y 90.0°").waitFor();
  await mouse.up();
  // Right-handed about y, which points away: z goes to x.
  await until(async () => (await editor.vertex(2)).map((mm) => Math.round(mm * 1e6) / 1e6)).toEqual([92.5, 0, 32.5]);
  expect(await apart(1, 2)).toBeCloseTo(80, 9);
  await press("Control+z");
  await until(() => editor.vertex(2)).toEqual([60, 0, 80]);

  await mouse.move(x + beside, y - beside);
  await mouse.down();
  await mouse.move(x + 60, y - 2, { steps: 4 });
  for (const key of "-30") await press(key);
  await editor.page.getByText("about y −30▏°").waitFor();
  await mouse.up();
  // From the middle 7.5 to the right and 40 up, turned back by 30°.
  const [sin, cos] = [Math.sin(-Math.PI / 6), Math.cos(-Math.PI / 6)];
  await until(() => editor.vertex(2)).not.toEqual([60, 0, 80]);
  const [left, , up] = await editor.vertex(2);
  expect(left).toBeCloseTo(52.5 + 7.5 * cos + 40 * sin, 6);
  expect(up).toBeCloseTo(40 - 7.5 * sin + 40 * cos, 6);
});
