import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";
import { type Place, Sight } from "../../support/sight.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const trace = () => editor.section("trace");

/** A cube of 2 as an STL, which does not say 2 of what. */
function cube(): string {
  const corner = (k: number): string => [k & 1, (k >> 1) & 1, k >> 2].map((bit) => bit * 2).join(" ");
  const faces = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  const triangles = faces.flatMap(([a = 0, b = 0, c = 0, d = 0]) => [
    [a, b, c],
    [a, c, d],
  ]);
  const facet = (corners: number[]) =>
    `facet normal 0 0 0\nouter loop\n${corners.map((k) => `vertex ${corner(k)}`).join("\n")}\nendloop\nendfacet\n`;
  return `solid cube\n${triangles.map(facet).join("")}endsolid cube\n`;
}

const INCH = 25.4;
/** Corners of the cube in mm, once it is read as inches. */
const CORNERS: readonly Place[] = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [
  (k & 1) * 2 * INCH,
  ((k >> 1) & 1) * 2 * INCH,
  (k >> 2) * 2 * INCH,
]);

/** Clicks where something is to be snapped to, once it is shown that it would be. */
async function click(place: { x: number; y: number }, snap: string): Promise<void> {
  await editor.page.mouse.move(place.x - 3, place.y - 2);
  await editor.page.mouse.move(place.x, place.y);
  await editor.page.locator(".hover-card", { hasText: snap }).waitFor();
  await editor.page.mouse.click(place.x, place.y);
}

it("asks once what the numbers of a stencil measure, and says what size comes out", async () => {
  await editor.reload("trace", "edit");
  await editor.drop("cube.stl", cube());
  const dialog = editor.page.getByRole("dialog", { name: "Open cube.stl" });
  await dialog.getByRole("status").filter({ hasText: "2.0 × 2.0 × 2.0 mm" }).waitFor();
  await dialog.getByLabel("Unit").selectOption("inch");
  await dialog.getByRole("status").filter({ hasText: "50.8 × 50.8 × 50.8 mm" }).waitFor();
  await editor.isCleanNow("trace-units");
  await dialog.getByRole("button", { name: "Open" }).click();
  await trace().getByText("12 faces").first().waitFor();
  // What the notes of the file are shown in leaves the help at the pointer readable.
  const [hint, notes] = await Promise.all(
    [".pointer-hint", ".open-notes"].map((of) => editor.page.locator(of).boundingBox()),
  );
  expect((hint?.x ?? 0) + (hint?.width ?? 0)).toBeLessThanOrEqual(notes?.x ?? 0);
  expect(await dialog.count()).toBe(0);
  expect((await editor.design()).state.stencils.map(({ surface }) => surface?.faces)).toEqual([12]);
});

it("snaps to corners of the stencil, shows so before the click, and ends a strand on a vertex", async () => {
  const sight = await Sight.from(editor.page, "front", CORNERS);
  await editor.page.keyboard.press("t");
  const size = 2 * INCH;
  const corners: readonly Place[] = [
    [0, 0, 0],
    [size, 0, 0],
    [size, 0, size],
    [0, 0, size],
  ];
  for (const corner of corners) await click(sight.at(corner), "Corner of the stencil");
  await until(async () => (await editor.design()).vertices.length).toBe(4);
  await trace().getByText("3 edges drawn").waitFor();
  await editor.isClean("trace");
  await click(sight.at([0, 0, 0]), "Vertex");
  await trace().getByText("Click on the stencil to begin a strand.").waitFor();
  const { vertices, edges } = await editor.design();
  expect(edges).toHaveLength(4);
  for (const { at_mm } of vertices) {
    // Exactly a corner: the mesh is kept in single precision.
    expect(CORNERS.some((corner) => corner.every((value, k) => Math.abs(value - (at_mm[k] ?? NaN)) < 1e-5))).toBe(true);
  }
  expect(new Set(vertices.map(({ at_mm }) => at_mm.map(Math.round).join()))).toHaveProperty("size", 4);
});

it("places a vertex off the stencil by half the wire, or by what is typed, on each face that meets there", async () => {
  await editor.button("Half the wire").click();
  const field = trace().getByLabel("Surface offset");
  await until(() => field.inputValue()).toContain("1.5");
  await field.fill("4");
  await field.press("Enter");
  const sight = await Sight.from(editor.page, "front", CORNERS);
  await editor.page.keyboard.press("t");
  const size = 2 * INCH;
  await click(sight.at([INCH, 0, size]), "Edge of the stencil");
  await until(async () => (await editor.design()).vertices.length).toBe(4);
  await click(sight.at([INCH / 2, 0, INCH]), "On the stencil");
  await until(async () => (await editor.design()).vertices.length).toBe(6);
  await editor.isClean("trace-offset");
  const [edge, surface] = (await editor.design()).vertices.slice(4).map(({ at_mm }) => at_mm);
  // Off the front and the top; off the front alone.
  expect(edge?.[1]).toBeCloseTo(-4, 4);
  expect(edge?.[2]).toBeCloseTo(size + 4, 4);
  expect(surface?.[1]).toBeCloseTo(-4, 4);
  expect(surface?.[2]).toBeCloseTo(INCH, 0);
  // Beside the corner that it was placed by the vertex is out of reach: the corner stands for it.
  // While a strand is drawn a digit is a length.
  await editor.page.keyboard.press("Escape");
  const aside = await Sight.from(editor.page, "right", [...CORNERS, [INCH, -4, size + 4]]);
  for (const corner of [
    [size, size, 0],
    [size, size, size],
  ] as const)
    await click(aside.at(corner), "Corner of the stencil");
  await until(async () => (await editor.design()).vertices.length).toBe(8);
  await click(aside.at([size, size, 0]), "Vertex");
  await trace().getByText("Click on the stencil to begin a strand.").waitFor();
  expect((await editor.design()).vertices).toHaveLength(8);
  while ((await editor.design()).vertices.length > 4) await editor.page.keyboard.press("Control+z");
  await field.fill("0");
  await field.press("Enter");
});

it("makes nothing of a first click that Escape follows", async () => {
  const sight = await Sight.from(editor.page, "front", CORNERS);
  await click(sight.at([INCH, 0, INCH]), "On the stencil");
  await editor.page.keyboard.press("Escape");
  expect((await editor.design()).vertices).toHaveLength(4);
});

it("hides the stencil, changes how much of it is seen, and takes it away", async () => {
  await editor.button("Hide all").click();
  await editor.button("Show all").click();
  const slider = trace().getByLabel("Opacity of the stencils");
  await slider.fill("0.9");
  expect(await slider.getAttribute("aria-valuetext")).toMatch(/^90.?%$/);
  await editor.button("Place or remove…").click();
  await editor.button("Remove cube.stl").click();
  await trace().getByText("no stencil").waitFor();
  expect((await editor.design()).state.stencils).toEqual([]);
  await editor.page.keyboard.press("Control+z");
  await trace().getByText("12 faces").first().waitFor();
});

it("draws on a plane, on the grid of it", async () => {
  await editor.take(null, "trace", "edit");
  await editor.page.keyboard.press("d");
  await trace().getByText("XZ", { exact: true }).click();
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("1");
  // Nothing is there to find one's way by: the view reports the places itself, before each click.
  const canvas = await editor.page.locator(".viewport canvas").boundingBox();
  const [x, y] = [(canvas?.x ?? 0) + 400, (canvas?.y ?? 0) + 300];
  const seen: Place[] = [];
  for (const [dx, dy] of [
    [0, 0],
    [150, 0],
    [150, 150],
  ] as const) {
    await editor.page.mouse.move(x + dx - 5, y + dy);
    await editor.page.mouse.move(x + dx, y + dy, { steps: 3 });
    const card = editor.page.locator(".hover-card", { hasText: /Grid|On the plane|Direction in steps/ });
    await card.waitFor();
    const figures =
      (await card.innerText())
        .replaceAll("\u2212", "-")
        .match(/-?\d+\.\d/g)
        ?.map(Number) ?? [];
    seen.push([figures[0] ?? NaN, figures[1] ?? NaN, figures[2] ?? NaN]);
    await editor.page.mouse.click(x + dx, y + dy);
  }
  await until(async () => (await editor.design()).vertices.length).toBe(3);
  const { vertices, edges } = await editor.design();
  expect(edges).toHaveLength(2);
  vertices.forEach(({ at_mm }, index) =>
    at_mm.forEach((value, k) => expect(value).toBeCloseTo(seen[index]?.[k] ?? NaN, 1)),
  );
  expect(vertices.every(({ at_mm }) => Math.abs(at_mm[1]) < 1e-9)).toBe(true);
  await editor.isClean("trace-draw");
});

it("makes an edge as long as is typed, towards the pointer", async () => {
  const canvas = await editor.page.locator(".viewport canvas").boundingBox();
  await editor.page.mouse.move((canvas?.x ?? 0) + 620, (canvas?.y ?? 0) + 450, { steps: 3 });
  await editor.page.getByText(/^edge \d+\.\d mm · \d+\.\d°\s+Tab: angle$/).waitFor();
  await editor.page.keyboard.type("42.5");
  await editor.page.getByText(/^edge 42\.5▏ mm · .*Enter: place$/).waitFor();
  await editor.page.keyboard.press("Enter");
  await until(async () => (await editor.design()).vertices.length).toBe(4);
  const { vertices, edges } = await editor.design();
  const [from, to] = vertices.slice(-2).map(({ at_mm }) => at_mm);
  expect(Math.hypot(...[0, 1, 2].map((k) => (to?.[k] ?? NaN) - (from?.[k] ?? NaN)))).toBeCloseTo(42.5, 9);
  expect([edges.length, (to?.[0] ?? 0) > (from?.[0] ?? 0)]).toEqual([3, true]);
  // The strand continues from there, and a length that is given up leaves it open.
  await editor.page.keyboard.type("7");
  await editor.page.keyboard.press("Escape");
  await trace().getByText("3 edges drawn").waitFor();
  await editor.page.keyboard.press("Escape");
  await trace().getByText("Click on the plane to begin a strand").waitFor();
});

it("draws in steps of 15°, which Shift frees, and shows length and angle beside the edge", async () => {
  await editor.take(null, "trace");
  await editor.page.keyboard.press("d");
  await trace().getByText("XZ", { exact: true }).click();
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("1");
  const canvas = await editor.page.locator(".viewport canvas").boundingBox();
  const [x, y] = [(canvas?.x ?? 0) + 300, (canvas?.y ?? 0) + 400];
  await editor.page.mouse.click(x, y);
  await editor.page.mouse.move(x + 200, y - 10, { steps: 3 });
  await editor.page.locator(".hover-card", { hasText: "Direction in steps of 15°" }).waitFor();
  const band = editor.page.locator(".viewport").getByText(/^\d+\.\d mm · \d+\.\d°$/);
  await until(() => band.innerText()).toMatch(/mm · 0\.0°$/);
  await editor.isCleanNow("trace-band");
  await editor.page.mouse.move(x + 200, y - 110, { steps: 3 });
  await until(() => band.innerText()).toMatch(/mm · 30\.0°$/);
  await editor.page.keyboard.down("Shift");
  await editor.page.mouse.move(x + 200, y - 109, { steps: 2 });
  await until(() => band.innerText()).not.toMatch(/(0|5)\.0°$/);
  await editor.page.keyboard.up("Shift");
});

it("places an edge by a typed length and a typed angle, with Tab between them", async () => {
  await editor.page.keyboard.type("60");
  await editor.page.keyboard.press("Tab");
  await editor.page.keyboard.type("105");
  await editor.page.locator(".viewport").getByText("60 mm · 105▏°", { exact: true }).waitFor();
  await editor.isCleanNow("trace-typed");
  await editor.page.keyboard.press("Enter");
  await until(async () => (await editor.design()).vertices.length).toBe(2);
  const [from, to] = (await editor.design()).vertices.map(({ at_mm }) => at_mm);
  const [x, z] = [(to?.[0] ?? NaN) - (from?.[0] ?? NaN), (to?.[2] ?? NaN) - (from?.[2] ?? NaN)];
  expect(Math.hypot(x, z)).toBeCloseTo(60, 9);
  expect((Math.atan2(z, x) * 180) / Math.PI).toBeCloseTo(105, 9);
  await editor.page.keyboard.press("Escape");
});

it("draws on a plane through three vertices", async () => {
  await editor.take(null, "trace", "edit");
  const corners: Place[] = [
    [0, 0, 0],
    [80, 0, 0],
    [0, 60, 80],
  ];
  await editor.loopback.ask("edit", { request: { edit: "draw", through_mm: corners.map((at) => [...at]) } });
  await editor.reload("trace", "edit");
  await editor.section("edit").locator(".section-phrase", { hasText: "3 vert" }).waitFor();
  await trace().getByText("Points: through three selected vertices, or three clicks.").waitFor();
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("a");
  await trace().getByText("Points", { exact: true }).click();
  await trace().getByText("Through vertices 0, 1 and 2.").waitFor();
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("d");
  const canvas = await editor.page.locator(".viewport canvas").boundingBox();
  const [x, y] = [(canvas?.x ?? 0) + 300, (canvas?.y ?? 0) + 300];
  for (const [dx, dy] of [
    [0, 0],
    [60, 40],
  ] as const) {
    await editor.page.mouse.move(x + dx - 5, y + dy);
    await editor.page.mouse.move(x + dx, y + dy, { steps: 3 });
    await editor.page.locator(".hover-card", { hasText: /Grid|On the plane|Direction in steps/ }).waitFor();
    await editor.page.mouse.click(x + dx, y + dy);
  }
  await until(async () => (await editor.design()).vertices.length).toBe(5);
  // The plane through them is 4·y = 3·z.
  for (const { at_mm } of (await editor.design()).vertices.slice(3)) {
    expect(4 * at_mm[1]).toBeCloseTo(3 * at_mm[2], 6);
    expect(Math.abs(at_mm[2])).toBeGreaterThan(1);
  }
  await editor.isClean("trace-own-plane");
  await editor.page.keyboard.press("Escape");
  await editor.page.keyboard.press("q");
});

it("writes the dimensions of all edges and angles, and takes them away again", async () => {
  await editor.take("house", "edit");
  const view = editor.page.locator(".viewport");
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("1");
  await editor.page.keyboard.press("Home");
  expect(await view.getByText("60.0 mm", { exact: true }).count()).toBe(0);
  await editor.page.keyboard.press("n");
  await until(() => view.getByText("60.0 mm", { exact: true }).count()).toBe(2);
  await until(() => view.getByText("90.0°", { exact: true }).count()).toBe(2);
  await editor.isClean("dimensions");
  await editor.page.keyboard.press("n");
  await until(() => view.getByText("60.0 mm", { exact: true }).count()).toBe(0);
});
