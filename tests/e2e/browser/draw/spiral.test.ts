import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

/** A figure in the field that has the focus, with the key that takes it. */
const type = (figure: string, end: "Enter" | "Tab" = "Enter") => editor.keys(...figure, end);

const array = () => editor.section("edit").locator("#operation-array");

async function click(label: string): Promise<void> {
  editor.handled += 1;
  await array().getByLabel(label, { exact: true }).click();
}

const size = async () => {
  const { vertices, edges } = await editor.design();
  return [vertices.length, edges.length];
};

/** Where the pointer would place a vertex. */
async function pointed(x: number, y: number): Promise<number[]> {
  await editor.page.mouse.move(x - 3, y);
  await editor.page.mouse.move(x, y, { steps: 2 });
  const card = editor.page.locator(".hover-card");
  await card.waitFor();
  const figures = (await card.innerText()).replaceAll("\u2212", "-").match(/-?\d+\.\d/g);
  return figures?.map(Number) ?? [];
}

it("makes a hexagonal spiral of one edge and an array, in at most 30 clicks and keys", async () => {
  await editor.take(null, "trace", "edit");
  await editor.page.keyboard.press("d");
  const canvas = editor.page.locator(".viewport canvas");
  await canvas.focus();

  // A side of a hexagon of radius 50 about the origin: from (50, 0) 50 mm long at 120°.
  const box = await canvas.boundingBox();
  const [x, y] = [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
  const [right = NaN] = await pointed(x + 200, y);
  const begin = x + (200 * 50) / right;
  expect(await pointed(begin, y)).toEqual([50, 0, 0]);
  editor.handled += 1;
  await editor.page.mouse.click(begin, y);
  await pointed(begin - 40, y - 60);
  await editor.keys("5", "0", "Tab", "1", "2", "0", "Enter");
  await until(size).toEqual([2, 1]);

  // Its end rises by a sixth of a turn's pitch of 60.
  await editor.keys("Escape");
  editor.handled += 1;
  await editor.section("edit").getByRole("table", { name: "Vertices" }).getByLabel("Vertex 1, Z, mm").click();
  await type("10");
  await until(async () => (await editor.design()).vertices[1]?.at_mm[2]).toBe(10);

  editor.handled += 1;
  await canvas.focus();
  await editor.keys("a");
  editor.handled += 1;
  await editor.section("edit").locator("#operation-array .operation-head").click();
  editor.handled += 1;
  await array().getByText("Circular", { exact: true }).click();
  await click("Copies");
  await type("17", "Tab");
  await click("Angle per copy");
  await type("60", "Tab");
  await type("10");
  await editor.isClean("spiral-array");
  editor.handled += 1;
  await array().getByRole("button", { name: "Make 17 copies" }).click();
  await until(size).toEqual([19, 18]);

  const { vertices } = await editor.design();
  const steps = vertices.map(({ at_mm }) => at_mm).sort((a, b) => a[2] - b[2]);
  steps.forEach((at, step) => {
    const turned = (step * Math.PI) / 3;
    const drawing = [50 * Math.cos(turned), 50 * Math.sin(turned), 10 * step];
    expect(Math.hypot(...drawing.map((value, k) => value - (at[k] ?? NaN))), `step ${step}`).toBeLessThan(0.1);
  });
  await editor.isClean("spiral");
  const check = await editor.loopback.ask("check", { moved: [] });
  expect([check.feasible, check.diagnostics.filter(({ severity }) => severity !== "info")]).toEqual([true, []]);
  expect(editor.handled).toBeLessThanOrEqual(30);
});
