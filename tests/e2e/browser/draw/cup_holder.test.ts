import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";
import { type Place, Sight } from "../../support/sight.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const size = async () => {
  const { vertices, edges } = await editor.design();
  return [vertices.length, edges.length];
};

/** What the holder goes round, and the wire. */
const [ACROSS, HIGH, WIRE] = [80, 75, 3];

const SIDES = 48;

/** A cylinder of 80 mm across and 75 mm high, standing on the origin, as a mesh of 48 sides. */
function cylinder(): string {
  const at = (k: number, z: number) => {
    const angle = (2 * Math.PI * k) / SIDES;
    return `v ${((ACROSS / 2) * Math.cos(angle)).toFixed(6)} ${((ACROSS / 2) * Math.sin(angle)).toFixed(6)} ${z}`;
  };
  const rounds = [...Array(SIDES).keys()];
  const faces = rounds.map((k) => {
    const [a, b] = [k + 1, ((k + 1) % SIDES) + 1];
    return `f ${a} ${b} ${b + SIDES} ${a + SIDES}`;
  });
  const ends = [rounds.map((k) => SIDES - k), rounds.map((k) => SIDES + k + 1)].map((end) => `f ${end.join(" ")}`);
  return [...rounds.map((k) => at(k, 0)), ...rounds.map((k) => at(k, HIGH)), ...faces, ...ends, ""].join("\n");
}

/** How far off the stencil it is traced: the middles of an octagon have to clear the cup by half of the wire. */
const OFFSET = 4.92;
const [LOW, TOP] = [-OFFSET, HIGH + OFFSET];

function around(radius: number, eighth: number, z: number): Place {
  const angle = (eighth * Math.PI) / 4;
  return [radius * Math.cos(angle), radius * Math.sin(angle), z];
}

/** Every sixth corner of a rim of the stencil. */
const rim = (eighth: number, z: number): Place => around(ACROSS / 2, eighth, z);

/** Where the wire goes there: as far off the end of the cup as off the two sides that meet in the corner. */
const corner = (eighth: number, z: number): Place => around(ACROSS / 2 + OFFSET / Math.cos(Math.PI / SIDES), eighth, z);

const RING = [0, 1, 2, 3, 4, 5, 6, 7];
/** What there is to frame. */
const outermost: Place[] = [0, HIGH].flatMap((z) => RING.map((eighth) => rim(eighth, z)));

/**
 * Clicks on what is there, once it is shown that it would be taken. A vertex that has just been placed is drawn a moment later, and until
 * then the one at the other end of the cup is there in its place.
 */
async function take(place: { x: number; y: number }, snap: string, z: number): Promise<void> {
  const height = `z ${z < 0 ? "\u2212" : ""}${Math.abs(z).toFixed(1)} mm`;
  const card = editor.page.locator(".hover-card", { hasText: snap }).filter({ hasText: height });
  // A view that was still turning has shown what lay there before.
  await until(async () => {
    await editor.page.mouse.move(place.x - 3, place.y - 2);
    await editor.page.mouse.move(place.x, place.y);
    return card.isVisible();
  }).toBe(true);
  editor.handled += 1;
  await editor.page.mouse.click(place.x, place.y);
}

/** Looks from a side or, with Control, from the other: the holder is the same from both. */
async function look(side: "front" | "top", ...keys: string[]): Promise<(place: Place) => { x: number; y: number }> {
  await editor.keys(...keys);
  const sight = await Sight.framed(editor.page, side, outermost);
  return (place) => sight.at(place);
}

it("traces a holder for a cup of 80 mm on a stencil of it, in at most 50 clicks and keys", async () => {
  await editor.take(null, "trace", "edit");
  editor.handled += 1;
  await editor.drop("cup.obj", cylinder());
  const dialog = editor.page.getByRole("dialog", { name: "Open cup.obj" });
  await dialog.getByRole("status").filter({ hasText: "80.0 × 80.0 × 75.0 mm" }).waitFor();
  editor.handled += 1;
  await dialog.getByRole("button", { name: "Open" }).click();
  await editor.section("trace").getByText("50 faces").first().waitFor();

  editor.handled += 1;
  await editor.section("trace").getByLabel("Surface offset").click();
  await editor.keys(...String(OFFSET), "Tab");

  // A ring off the upper rim, and one on the lower, seen from below: what the cup covers is not taken.
  await editor.page.locator(".viewport canvas").focus();
  const above = await look("top", "7", "Home");
  await editor.keys("t");
  for (const eighth of RING) await take(above(rim(eighth, HIGH)), "Corner of the stencil", TOP);
  await take(above(corner(0, TOP)), "Vertex", TOP);
  await until(size).toEqual([8, 8]);
  await editor.isCleanNow("cup-ring");
  outermost.push(...RING.map((eighth) => corner(eighth, TOP)));
  const below = await look("top", "Control+7", "Home");
  for (const eighth of RING) await take(below(rim(-eighth, 0)), "Corner of the stencil", LOW);
  await take(below(corner(0, LOW)), "Vertex", LOW);
  await until(size).toEqual([16, 16]);
  outermost.push(...RING.map((eighth) => corner(eighth, LOW)));

  // A cross under the cup: a bar, and another through its middle.
  await take(below(corner(1, LOW)), "Vertex", LOW);
  await take(below(corner(5, LOW)), "Vertex", LOW);
  await until(size).toEqual([16, 17]);
  await take(below(corner(3, LOW)), "Vertex", LOW);
  await take(below([0, 0, LOW]), "Middle of an edge", LOW);
  await until(size).toEqual([17, 19]);
  await take(below([0, 0, LOW]), "Vertex", LOW);
  await take(below(corner(7, LOW)), "Vertex", LOW);
  await until(size).toEqual([17, 20]);
  // Until the window has heard so, too, a digit is the length of what comes next.
  await editor.section("trace").getByText("Click on the stencil to begin a strand.").waitFor();

  // Four struts, two from the front and two from behind.
  for (const keys of [["1", "Home"], ["Control+1"]]) {
    const at = await look("front", ...keys);
    for (const eighth of [5, 7]) {
      await take(at(corner(eighth, TOP)), "Vertex", TOP);
      await take(at(corner(eighth, LOW)), "Vertex", LOW);
    }
  }
  await until(size).toEqual([17, 24]);
  expect(editor.handled).toBeLessThanOrEqual(50);
  await editor.page.keyboard.press("Escape");
  await editor.isClean("cup");

  const { vertices, edges } = await editor.design();
  const drawing = [...RING.flatMap((k) => [corner(k, LOW), corner(k, TOP)]), [0, 0, LOW]];
  const found = drawing.map((place) =>
    vertices.findIndex(({ at_mm }) => Math.hypot(...place.map((value, k) => value - (at_mm[k] ?? NaN))) < 0.001),
  );
  expect([...found].sort((a, b) => a - b)).toEqual([...vertices.keys()]);
  const pair = (a: number, b: number) => `${Math.min(a, b)} ${Math.max(a, b)}`;
  const joined = new Set(edges.map(({ a, b }) => pair(a, b)));
  const id = (index: number) => vertices[found[index] ?? -1]?.id ?? NaN;
  const [low, high] = [(eighth: number) => id(2 * (eighth % 8)), (eighth: number) => id(2 * (eighth % 8) + 1)];
  for (const eighth of RING) {
    expect(joined).toContain(pair(low(eighth), low(eighth + 1)));
    expect(joined).toContain(pair(high(eighth), high(eighth + 1)));
  }
  // The struts stand upright at every second corner, and the bars meet in the middle.
  for (const eighth of [1, 3, 5, 7]) {
    expect(joined).toContain(pair(low(eighth), high(eighth)));
    expect(joined).toContain(pair(low(eighth), id(16)));
  }
  // The cup goes in: the wire leaves 80 mm free between the sides of a ring.
  const middles = RING.map((eighth) => {
    const [a, b] = [low(eighth), low(eighth + 1)].map((ring) => vertices.find((vertex) => vertex.id === ring)?.at_mm);
    return Math.hypot(...[0, 1].map((k) => ((a?.[k] ?? NaN) + (b?.[k] ?? NaN)) / 2));
  });
  for (const middle of middles) expect(middle - WIRE / 2).toBeGreaterThanOrEqual(ACROSS / 2);
});
