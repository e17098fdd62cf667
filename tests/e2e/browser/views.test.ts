import { afterAll, beforeAll, expect, it } from "vitest";
import { picture } from "../support/browser.ts";
import { Editor, until } from "../support/editor.ts";
import { root } from "../support/places.ts";
import { type Place, Sight } from "../support/sight.ts";

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

it("looks from all six sides, by keys and by buttons", async () => {
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
  for (const name of ["Back", "Left", "Bottom", "Front"]) {
    await editor.page.getByRole("group", { name: "View" }).getByRole("button", { name }).click();
    await until(view).toBe(name);
  }
  await editor.page.getByText("Orbit: right or middle button").waitFor();
  await editor.isClean("views");
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
