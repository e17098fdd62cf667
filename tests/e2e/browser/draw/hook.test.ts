import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

it("draws a wall hook with two fillets to a tenth of a millimetre, in at most 25 clicks and keys", async () => {
  await editor.take(null, "trace", "edit");
  await editor.page.keyboard.press("d");
  await editor.section("trace").getByText("XZ", { exact: true }).click();
  await editor.page.locator(".viewport canvas").focus();
  const canvas = await editor.page.locator(".viewport canvas").boundingBox();
  const [x, y] = [(canvas?.x ?? 0) + 300, (canvas?.y ?? 0) + 420];
  const { mouse } = editor.page;
  /** The pointer shows the way of the next edge, in steps of 15°. */
  const towards = async (right: number, up: number) => {
    await mouse.move(x + right - 3, y - up);
    await mouse.move(x + right, y - up, { steps: 2 });
    await editor.page.locator(".hover-card").waitFor();
  };

  await towards(0, 0);
  editor.handled += 1;
  await mouse.click(x, y);
  await towards(0, 300);
  await editor.keys("1", "2", "0", "Enter");
  await until(async () => (await editor.design()).vertices.length).toBe(2);
  await towards(320, 315);
  await editor.keys("1", "1", "0", "Enter");
  await until(async () => (await editor.design()).vertices.length).toBe(3);
  await towards(289, 100);
  await editor.keys("7", "0", "Enter");
  await until(async () => (await editor.design()).vertices.length).toBe(4);
  await editor.keys("Escape", "a", "b");
  const radius = editor.section("edit").locator("#operation-fillet").getByLabel("Radius");
  await until(() => radius.evaluate((field) => field === document.activeElement)).toBe(true);
  await editor.keys("3", "6", "Enter");
  await editor.messages
    .filter({ hasText: "2 corners rounded to a radius of 36.0 mm with 4 chords, the shortest 27.6 mm" })
    .waitFor();
  await until(async () => (await editor.design()).edges.length).toBe(7);

  // The hook as a drawing has it: 120 up, 110 across, 70 down; each quarter of radius 36 in two chords of 45°, since three would be
  // shorter than the machine's shortest feed of 25 mm.
  const slant = 36 * Math.SQRT1_2;
  const drawing = [
    [0, 0],
    [0, 84],
    [36 - slant, 84 + slant],
    [36, 120],
    [74, 120],
    [74 + slant, 84 + slant],
    [110, 84],
    [110, 50],
  ];
  const { vertices } = await editor.design();
  const [start] = vertices;
  const found = vertices.map(({ at_mm }) => [at_mm[0] - (start?.at_mm[0] ?? NaN), at_mm[2] - (start?.at_mm[2] ?? NaN)]);
  for (const [right = NaN, up = NaN] of drawing) {
    const off = found.map(([a = NaN, b = NaN]) => Math.hypot(a - right, b - up));
    expect(Math.min(...off), `${right}, ${up}`).toBeLessThan(0.1);
  }
  expect([vertices.length, vertices.every(({ at_mm }) => Math.abs(at_mm[1]) < 0.1)]).toEqual([drawing.length, true]);
  const check = await editor.loopback.ask("check", { moved: [] });
  expect([check.feasible, check.diagnostics.filter(({ severity }) => severity !== "info")]).toEqual([true, []]);
  await editor.isClean("hook");
  expect(editor.handled).toBeLessThanOrEqual(25);
});

it("answers a radius that the machine cannot make with the nearest one", async () => {
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("Control+z");
  await until(async () => (await editor.design()).edges.length).toBe(3);
  await editor.page.keyboard.press("a");
  const form = editor.section("edit").locator("#operation-fillet");
  await form.getByLabel("Radius").fill("10");
  await form.getByRole("button", { name: /^Use 3\d\.\d mm$/ }).waitFor();
  await form.getByLabel("Radius").press("Enter");
  expect((await editor.design()).edges).toHaveLength(3);
  // Whoever asks in spite of that is told the same.
  const { vertices } = await editor.design();
  const request = {
    edit: "fillet",
    vertices: vertices.slice(1, 3).map(({ id }) => id),
    radius_mm: 10,
    step_deg: 15,
  } as const;
  await expect(editor.loopback.ask("edit", { request })).rejects.toThrow("the shortest that can be made there");
});
