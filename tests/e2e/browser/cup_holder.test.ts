import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../support/editor.ts";
import { type Place, Sight } from "../support/sight.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const shapes = () => editor.section("edit").getByRole("group", { name: "Shapes" });

/** Clicks a figure, and types it over. */
async function figure(label: string, text: string): Promise<void> {
  editor.handled += 1;
  await shapes().getByRole("textbox", { name: label, exact: true }).click();
  await editor.keys(...text, "Tab");
}

const size = async () => {
  const { vertices, edges } = await editor.design();
  return [vertices.length, edges.length];
};

/** A cup of 80 mm across and 100 mm high, standing on the origin, as a mesh of 48 sides. */
function cup(): string {
  const SIDES = 48;
  const at = (k: number, z: number) => {
    const angle = (2 * Math.PI * k) / SIDES;
    return `v ${(40 * Math.cos(angle)).toFixed(6)} ${(40 * Math.sin(angle)).toFixed(6)} ${z}`;
  };
  const rounds = [...Array(SIDES).keys()];
  const faces = rounds.flatMap((k) => {
    const [a, b] = [k + 1, ((k + 1) % SIDES) + 1];
    return [`f ${a} ${b} ${b + SIDES} ${a + SIDES}`];
  });
  const ends = [rounds.map((k) => SIDES - k), rounds.map((k) => SIDES + k + 1)].map((end) => `f ${end.join(" ")}`);
  return [...rounds.map((k) => at(k, 0)), ...rounds.map((k) => at(k, 100)), ...faces, ...ends, ""].join("\n");
}

/** The middle of the wire beside the cup: half of its 3 mm away. */
const FLATS = 41.5;
const [LOW, HIGH] = [-1.5, 75];

/** A corner of a ring: an octagon that touches the cup with its sides. */
function corner(eighth: number, z: number): Place {
  const radius = FLATS / Math.cos(Math.PI / 8);
  const angle = (eighth * Math.PI) / 4;
  return [radius * Math.cos(angle), radius * Math.sin(angle), z];
}

const OUTERMOST: readonly Place[] = [
  ...[...Array(8).keys()].flatMap((k) => [corner(k, LOW), corner(k, HIGH)]),
  [0, 0, 0],
  [0, 0, 100],
];

/** Clicks on what is there, once it is shown that it would be taken. */
async function take(place: { x: number; y: number }, snap: string): Promise<void> {
  await editor.page.mouse.move(place.x - 3, place.y - 2);
  await editor.page.mouse.move(place.x, place.y);
  await editor.page.locator(".hover-card", { hasText: snap }).waitFor();
  editor.handled += 1;
  await editor.page.mouse.click(place.x, place.y);
}

/** Looks from the front or the back, or from below: the holder is the same from both sides. */
async function look(side: "front" | "top", key: string): Promise<(place: Place) => { x: number; y: number }> {
  await editor.keys(key, "Home");
  const sight = await Sight.framed(editor.page, side, OUTERMOST);
  return (place) => sight.at(place);
}

it("makes a holder for a cup of 80 mm that is a stencil, in at most 50 clicks and keys", async () => {
  await editor.take(null, "trace", "edit");
  await editor.drop("cup.obj", cup());
  const dialog = editor.page.getByRole("dialog", { name: "Open cup.obj" });
  await dialog.getByRole("status").filter({ hasText: "80.0 × 80.0 × 100.0 mm" }).waitFor();
  await dialog.getByRole("button", { name: "Open" }).click();
  await editor.section("trace").getByText("50 faces").first().waitFor();

  // Two rings.
  editor.handled += 1;
  await shapes().getByText("Polygon", { exact: true }).click();
  await figure("Centre, Z, mm", String(HIGH));
  editor.handled += 2;
  await shapes().getByLabel("Size is").selectOption("flats");
  await figure("Size", String(FLATS));
  await editor.keys(..."8");
  editor.handled += 1;
  await editor.isCleanNow("cup-ring");
  await shapes().getByRole("button", { name: "Add polygon" }).click();
  await until(size).toEqual([8, 8]);
  await figure("Centre, Z, mm", String(LOW));
  editor.handled += 1;
  await shapes().getByRole("button", { name: "Add polygon" }).click();
  await until(size).toEqual([16, 16]);

  // Four struts, two from the front and two from behind: what the cup covers is not taken.
  editor.handled += 1;
  await editor.page.locator(".viewport canvas").focus();
  await editor.keys("t");
  for (const key of ["1", "Control+1"]) {
    const at = await look("front", key);
    for (const eighth of [5, 7]) {
      await take(at(corner(eighth, HIGH)), "Vertex");
      await take(at(corner(eighth, LOW)), "Vertex");
    }
  }
  await until(size).toEqual([16, 20]);
  await editor.isCleanNow("cup-struts");

  // A cross under the cup: a bar, and another through its middle.
  const below = await look("top", "Control+7");
  await take(below(corner(1, LOW)), "Vertex");
  await take(below(corner(5, LOW)), "Vertex");
  await until(size).toEqual([16, 21]);
  await take(below(corner(3, LOW)), "Vertex");
  await take(below([0, 0, LOW]), "Middle of an edge");
  await until(size).toEqual([17, 23]);
  await take(below([0, 0, LOW]), "Vertex");
  await take(below(corner(7, LOW)), "Vertex");
  await until(size).toEqual([17, 24]);
  await editor.keys("Escape", "7", "5", "Home");
  await editor.isClean("cup");

  const { vertices, edges } = await editor.design();
  const drawing = [...[...Array(8).keys()].flatMap((k) => [corner(k, LOW), corner(k, HIGH)]), [0, 0, LOW]];
  const found = drawing.map((place) =>
    vertices.findIndex(({ at_mm }) => Math.hypot(...place.map((value, k) => value - (at_mm[k] ?? NaN))) < 0.1),
  );
  expect([...found].sort((a, b) => a - b)).toEqual([...vertices.keys()]);
  // The struts stand upright at every second corner, and the bars meet in the middle.
  const pair = (a: number, b: number) => `${Math.min(a, b)} ${Math.max(a, b)}`;
  const joined = new Set(edges.map(({ a, b }) => pair(a, b)));
  const id = (index: number) => vertices[found[index] ?? -1]?.id ?? NaN;
  for (const eighth of [1, 3, 5, 7]) {
    const low = id(2 * eighth);
    expect(joined).toContain(pair(low, id(2 * eighth + 1)));
    expect(joined).toContain(pair(low, id(16)));
  }
  expect(editor.handled).toBeLessThanOrEqual(50);
});
