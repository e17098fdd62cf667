import { afterAll, beforeAll, expect, it } from "vitest";
import { picture } from "../../support/browser.ts";
import { Editor, until } from "../../support/editor.ts";
import { root } from "../../support/places.ts";
import { type Place, Sight } from "../../support/sight.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const press = (key: string) => editor.page.keyboard.press(key);
const view = () =>
  editor.page
    .getByRole("group", { name: "View" })
    .getByRole("button", { pressed: true })
    .evaluate((button) => button.lastChild?.textContent ?? "");
const plane = () =>
  editor.section("trace").getByRole("radiogroup", { name: "Plane" }).getByRole("radio", { checked: true }).inputValue();
const card = () => editor.page.locator(".hover-card");

it("looks from all six sides, by keys and by the buttons of the view cube", async () => {
  await editor.take("house");
  await editor.page.locator(".viewport canvas").focus();
  for (const [key, name] of [
    ["1", "Front"],
    ["Control+1", "Back"],
    ["3", "Right"],
    ["Control+3", "Left"],
    ["7", "Top"],
    ["Control+7", "Bottom"],
  ] as const) {
    await press(key);
    await until(view).toBe(name);
  }
  // In sight once they have the focus.
  const button = (name: string) => editor.page.getByRole("group", { name: "View" }).getByRole("button", { name });
  for (const name of ["Back", "Left", "Bottom", "Front"]) {
    await button(name).focus();
    await press("Enter");
    await until(view).toBe(name);
  }
  await press("Tab");
  expect(
    await button("Back").evaluate((one) => [document.activeElement === one, getComputedStyle(one).opacity]),
  ).toEqual([true, "1"]);
  await picture(editor.page, "views-cube-focus");
  // With its keys in one line it covers nothing below the cube.
  const [back, below] = [await button("Back").boundingBox(), await button("Perspective").boundingBox()];
  expect((back?.y ?? Infinity) + (back?.height ?? 0)).toBeLessThanOrEqual(below?.y ?? 0);
  await editor.page.getByText("Orbit: right or middle button").waitFor();
  await editor.isClean("views");
});

/** A face, an edge or a corner of the view cube. */
const zone = (name: string) => editor.page.locator(`.view-cube [data-zone="${name}"]`).first();

it("turns to the faces, edges and corners of the view cube that are clicked, and with a drag of it", async () => {
  await editor.take("house");
  // Around the house: the edge between two sides is seen from both.
  for (const name of ["Right", "Back, right", "Back", "Back, left", "Left", "Top, left", "Top"]) {
    await zone(name).click();
    await until(view).toBe(name.includes(",") ? "Perspective" : name);
  }

  // Without perspective, and from a corner: what is in the design is where the projection along a cube's diagonal has it.
  await editor.page.locator(".viewport canvas").focus();
  for (const name of ["Perspective", "Parallel"]) {
    await press("5");
    await until(view).toBe(name);
  }
  await zone("Top, front, right").click();
  const faces = () => editor.page.locator(".cube-face text").allTextContents();
  await until(faces).toEqual(["Front", "Right", "Top"]);
  expect(await view()).toBe("Parallel");
  await editor.page.mouse.move(300, 400);
  await picture(editor.page, "views-cube-corner");
  const { vertices } = await editor.design();
  const [right, up] = [
    [Math.SQRT1_2, Math.SQRT1_2, 0],
    [-1 / Math.sqrt(6), 1 / Math.sqrt(6), Math.sqrt(2 / 3)],
  ] as const;
  const along = (way: readonly [number, number, number], at: Place) => way[0] * at[0] + way[1] * at[1] + way[2] * at[2];
  // The same picture as one from the front, of places that are as far to the right and up.
  const flat = vertices.map(({ at_mm }): Place => [along(right, at_mm), 0, along(up, at_mm)]);
  await editor.page.locator(".viewport canvas").focus();
  await press("Home");
  const sight = await Sight.framed(editor.page, "front", flat);
  for (const [index, vertex] of vertices.entries()) {
    const { x, y } = sight.at(flat[index] ?? [0, 0, 0]);
    await editor.page.mouse.move(x - 2, y);
    await editor.page.mouse.move(x, y);
    await card()
      .filter({ hasText: `Vertex ${vertex.id} ` })
      .waitFor();
  }

  // What would be chosen is marked.
  await zone("Top").hover();
  await until(() => zone("Top").getAttribute("class")).toContain("hovered");
  // At once for who wants no motion: the very next frame shows it.
  await editor.page.emulateMedia({ reducedMotion: "reduce" });
  await zone("Top").click();
  await editor.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  expect([await view(), await faces()]).toEqual(["Top", ["Top"]]);
  await editor.page.emulateMedia({ reducedMotion: null });

  const box = await zone("Top").boundingBox();
  const [x, y] = [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
  await editor.page.mouse.move(x, y);
  await editor.page.mouse.down();
  await editor.page.mouse.move(x + 8, y - 16, { steps: 4 });
  await editor.page.mouse.up();
  await until(view).toBe("Perspective");
  await until(faces).toContain("Front");
});

it("never shows the plane that is drawn on from its edge", async () => {
  await editor.take(null, "trace");
  await editor.page.locator(".viewport canvas").focus();
  await press("1");
  await press("d");
  // The ground would be a line from the front.
  await until(view).toBe("Top");
  await editor.section("trace").getByText("XZ", { exact: true }).click();
  await until(view).toBe("Front");
  await editor.page.locator(".viewport canvas").focus();
  // The plane goes with the view, as long as nothing is drawn on it.
  await press("Control+3");
  await until(view).toBe("Left");
  await until(plane).toBe("yz");
  const box = await editor.page.locator(".viewport canvas").boundingBox();
  const [x, y] = [(box?.x ?? 0) + 400, (box?.y ?? 0) + 300];
  for (const dx of [0, 120]) {
    await editor.page.mouse.move(x + dx - 4, y);
    await editor.page.mouse.move(x + dx, y, { steps: 3 });
    await card().waitFor();
    await editor.page.mouse.click(x + dx, y);
  }
  await until(async () => (await editor.design()).edges.length).toBe(1);
  // Until the window has it, too.
  await until(() => editor.page.locator(".status-figures dd").first().innerText()).not.toBe("–");
  await press("Control+1");
  expect([await view(), await plane()]).toEqual(["Left", "yz"]);
  // Nor does a turn by hand bring it there: what the pointer is on stays on the plane, and near.
  await editor.page.mouse.move(x, y + 60);
  await editor.page.mouse.down({ button: "right" });
  await editor.page.mouse.move(x + 300, y + 60, { steps: 30 });
  await editor.page.mouse.up({ button: "right" });
  await editor.page.mouse.move(x - 150, y + 30, { steps: 2 });
  await picture(editor.page, "views-turned");
  await card().filter({ hasText: "x 0.0" }).waitFor();
  await press("Escape");
  await press("q");
});

it("faces and frames a flat drawing that is opened", async () => {
  await editor.take(null);
  await editor.drop(`${root}examples/bracket.svg`);
  const dialog = editor.page.getByRole("dialog", { name: "Open bracket.svg" });
  await until(() => dialog.getByRole("button", { name: "Open" }).getAttribute("aria-disabled")).toBeNull();
  await dialog.getByRole("button", { name: "Open" }).click();
  await until(async () => (await editor.design()).vertices.length).toBeGreaterThan(5);
  await until(view).toBe("Top");
  const { vertices } = await editor.design();
  const places: Place[] = vertices.map(({ at_mm }) => at_mm);
  const sight = await Sight.framed(editor.page, "top", places);
  for (const vertex of [vertices[0], vertices.at(-1)]) {
    if (!vertex) throw new Error("the drawing has no vertices");
    const { x, y } = sight.at(vertex.at_mm);
    await editor.page.mouse.move(x - 2, y);
    await editor.page.mouse.move(x, y);
    await card()
      .filter({ hasText: `Vertex ${vertex.id} ` })
      .waitFor();
  }
  await picture(editor.page, "views-drawing");
});
