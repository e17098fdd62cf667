import { mkdirSync } from "node:fs";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor } from "../support/editor.ts";
import { root } from "../support/places.ts";

// The pictures of the README, in the order of its tutorial.

const folder = `${root}docs/pictures`;
let editor: Editor;

beforeAll(async () => {
  mkdirSync(folder, { recursive: true });
  editor = await Editor.open({ scheme: "dark" });
});

afterAll(async () => {
  await editor.end();
});

async function picture(name: string): Promise<void> {
  await editor.page.screenshot({ path: `${folder}/window-${name}.png`, animations: "disabled" });
}

it("makes the pictures", async () => {
  const { page } = editor;
  await page.getByText("Drop a model or a drawing here").waitFor();
  await page.locator("button.card").first().waitFor();
  await picture("start");

  // A surface to trace on, from the right, and a strand along it.
  await editor.take("bunny-stencil", "trace");
  await editor.section("trace").getByText(/triangles/).first().waitFor();
  await page.locator(".viewport canvas").focus();
  await page.keyboard.press("3");
  await page.keyboard.press("t");
  const canvas = page.locator("canvas").first();
  const box = (await canvas.boundingBox()) ?? { x: 0, y: 0, width: 1, height: 1 };
  const at = (x: number, y: number): [number, number] => [box.x + box.width * x, box.y + box.height * y];
  const strand: [number, number][] = [at(0.36, 0.84), at(0.62, 0.84), at(0.68, 0.62), at(0.58, 0.45), at(0.44, 0.44), at(0.37, 0.6)];
  for (const [x, y] of strand) {
    await page.mouse.move(x, y, { steps: 4 });
    await page.mouse.click(x, y);
  }
  await page.mouse.move(...at(0.36, 0.84), { steps: 6 });
  await picture("trace");
  await page.mouse.click(...at(0.36, 0.84));
  await page.keyboard.press("Escape");
  await page.keyboard.press("q");
  await editor.section("trace").locator("h2 > button").click();
  await editor.section("edit").locator("h2 > button").click();
  await page.locator(".viewport canvas").focus();
  await page.keyboard.press("a");
  await picture("edit");

  // Something to fix, and what a fix would do.
  await editor.take("truss", "check");
  await editor.section("check").getByRole("button", { name: /Fix/ }).first().click();
  await page.getByRole("button", { name: "Preview" }).first().click();
  await picture("check");
  await page.getByRole("button", { name: "Apply" }).first().click();
  await page.getByText("1 to fix").first().waitFor({ state: "hidden" });

  const only = async (from: Parameters<Editor["section"]>[0], to: Parameters<Editor["section"]>[0]) => {
    await editor.section(from).locator("h2 > button").click();
    await editor.section(to).locator("h2 > button").click();
  };
  await only("check", "animate");
  const slider = page.getByRole("slider").first();
  await slider.waitFor();
  // Somewhere in the middle of a bend.
  const track = (await page.getByRole("slider").last().boundingBox()) ?? { x: 0, y: 0, width: 1, height: 1 };
  await page.mouse.click(track.x + track.width * 0.43, track.y + track.height / 2);
  await page.keyboard.press("f");
  await picture("animate");

  await only("animate", "machine");
  await expect.poll(() => page.locator("#section-machine .card svg, #section-machine li svg").count()).toBeGreaterThanOrEqual(5);
  await picture("machine");

  await only("machine", "export");
  await page.locator("#section-export pre").first().waitFor();
  await picture("export");

  await only("export", "run");
  const port = page.locator("#section-run select").first();
  await port.waitFor();
  await port.selectOption({ value: "sim:10" });
  const run = page.locator("#section-run");
  await run.getByRole("button", { name: "Connect", exact: true }).click();
  await run.getByRole("button", { name: "Home", exact: true }).click();
  await run.getByRole("button", { name: "Arm…" }).click();
  await page.getByRole("button", { name: "Arm", exact: true }).click();
  await run.getByRole("button", { name: "Start", exact: true }).click();
  await page.getByText(/step [2-9] of/).first().waitFor();
  await picture("run");
  await page.keyboard.press("Control+Space");
  await page.getByText(/stopped/i).first().waitFor();
});
