import { mkdirSync } from "node:fs";
import { afterAll, beforeAll, expect, it } from "vitest";
import { SMOOTH } from "../support/browser.ts";
import { Editor, type Section, until } from "../support/editor.ts";
import { root } from "../support/places.ts";
import { type Place, Sight } from "../support/sight.ts";

// The pictures of the README, in the order of its tutorial: one design from the stencil to the machine; then those of frames.

const folder = `${root}docs/pictures`;

/** Corners of the bunny on the side that is looked at, from the right. */
const STRAND: readonly Place[] = [
  [72.9, -85.3, -75.8],
  [68.7, 66.2, -76.1],
  [43.4, 120.2, -26.8],
  [44.6, 108.4, 37.7],
  [57.4, 22.2, 82.1],
  [54.0, -80.9, 141.3],
  [72.4, -141.7, 73.1],
];
/** What is joined across it. */
const ACROSS = [
  [2, 4],
  [3, 6],
] as const;

let editor: Editor;

beforeAll(async () => {
  mkdirSync(folder, { recursive: true });
  editor = await Editor.open({ scheme: "dark" }, () => {}, [SMOOTH]);
});

afterAll(async () => {
  await editor.end();
});

async function picture(name: string): Promise<void> {
  // Without the ring that shows after use of the keyboard.
  await editor.page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await editor.page.screenshot({ path: `${folder}/window-${name}.png`, animations: "disabled" });
}

/** Opens a section and closes another. */
async function only(from: Section, to: Section): Promise<void> {
  await editor.section(from).locator("h2 > button").click();
  await editor.section(to).locator("h2 > button").click();
}

it("makes the pictures", async () => {
  const { page } = editor;
  await page.getByText("Drop a model or a drawing here").waitFor();
  await expect.poll(() => page.locator("button.card").count()).toBeGreaterThanOrEqual(3);
  await picture("start");

  // A surface to trace on, from the right, and a strand around it.
  await editor.take("bunny-stencil", "trace");
  await editor.section("trace").getByText(/faces/).first().waitFor();
  const whole = await editor.loopback.ask("look", { design: { input: { file: `${root}examples/bunny.obj` } } });
  const half = (whole.size_mm ?? [0, 0, 0]).map((size) => size / 2);
  // The bunny's box, of which the view shows the middle in its middle.
  const middle: Place = [4.98, 1.43, 80.17];
  const outermost = [-1, 1].map((side) => middle.map((at, axis) => at + side * (half[axis] ?? 0)) as unknown as Place);
  const sight = await Sight.from(page, "right", outermost);
  await page.keyboard.press("t");
  const to = async (place: Place) => {
    const { x, y } = sight.at(place);
    await page.mouse.move(x - 4, y);
    await page.mouse.move(x, y, { steps: 3 });
    return [x, y] as const;
  };
  const card = page.locator(".hover-card", { hasText: "Corner of the stencil" });
  for (const place of STRAND.slice(0, -1)) {
    const [x, y] = await to(place);
    await card.waitFor();
    await page.mouse.click(x, y);
  }
  const last = await to(STRAND.at(-1) as Place);
  await card.waitFor();
  await picture("trace");
  await page.mouse.click(...last);
  await page.mouse.click(...(await to(STRAND[0] as Place)));
  await until(async () => (await editor.design()).edges.length).toBe(STRAND.length);

  // Braced across: each pair is chosen and joined.
  await page.keyboard.press("q");
  await only("trace", "edit");
  for (const [from, other] of ACROSS) {
    const before = (await editor.design()).edges.length;
    await page.mouse.click(...(await to(STRAND[from] as Place)));
    const [x, y] = await to(STRAND[other] as Place);
    await page.keyboard.down("Shift");
    await page.mouse.click(x, y);
    await page.keyboard.up("Shift");
    await page.keyboard.press("c");
    await until(async () => (await editor.design()).edges.length).toBe(before + 1);
  }
  await picture("edit");

  // Four odd corners, and what a fix would do.
  await page.keyboard.press("Escape");
  await page.keyboard.press("5");
  await page.keyboard.press("Home");
  await only("edit", "check");
  await editor.section("check").getByRole("button", { name: /Fix/ }).first().click();
  const double = editor
    .section("check")
    .locator("li", { hasText: /^Run the wire along 1 edge/ })
    .last();
  await double.getByRole("button", { name: "Preview" }).click();
  await picture("check");
  await double.getByRole("button", { name: "Apply" }).click();
  await editor
    .section("check")
    .locator(".section-phrase", { hasText: /within limits|to look at/ })
    .waitFor();

  // How far off the machine will make it: the balls in the view, and what they come from.
  const accuracy = editor.section("check").locator(".part", { hasText: "Accuracy" });
  await accuracy.getByRole("button", { name: "Predict", exact: true }).click();
  await accuracy.getByRole("table", { name: "Expected accuracy" }).waitFor();
  await accuracy.getByRole("table", { name: "Tolerance" }).scrollIntoViewIfNeeded();
  await picture("accuracy");
  await accuracy.getByRole("checkbox", { name: "Show in the view" }).uncheck();

  // In the middle of a bend, more than half way through.
  await only("check", "animate");
  const slider = editor.section("animate").getByRole("slider").first();
  await slider.waitFor();
  await slider.fill(String(0.64 * Number(await slider.getAttribute("max"))));
  await page.locator(".viewport canvas").focus();
  await page.keyboard.press("f");
  await editor.section("animate").getByText(/6\d.%/).first().waitFor();
  await picture("animate");

  await only("animate", "machine");
  const cards = page.locator("#section-machine .machine-card");
  await until(
    async () =>
      (await cards.count()) ===
      (await page.locator("#section-machine .machine-card .machine-picture:has(polygon, path)").count()),
  ).toBe(true);
  await picture("machine");

  await only("machine", "export");
  await page.locator("#section-export pre").first().waitFor();
  await picture("export");

  await only("export", "run");
  const run = page.locator("#section-run");
  const port = run.locator("select").first();
  await port.waitFor();
  await port.selectOption({ value: "sim:10" });
  await run.getByRole("button", { name: "Connect", exact: true }).click();
  await run.getByRole("button", { name: "Home", exact: true }).click();
  // Until it is done with homing, arming has to wait, and a click says so alone.
  await run.locator(".run-phase.ready").waitFor();
  // The wire hits the machine's bodies, whose dimensions are estimates.
  await run.getByText("Bend it anyway").click();
  await page.waitForFunction(() =>
    [...document.querySelectorAll("#section-run button")].some(
      (button) => button.textContent === "Arm…" && !button.hasAttribute("aria-disabled"),
    ),
  );
  await run.getByRole("button", { name: "Arm…" }).click();
  await page.getByRole("button", { name: "Arm", exact: true }).click();
  await run.getByRole("button", { name: "Start", exact: true }).click();
  await page
    .getByText(/\b[5-9] of [0-9]+ steps done/)
    .first()
    .waitFor();
  await picture("run");
  await page.keyboard.press("Control+Space");
  await page
    .getByText(/stopped/i)
    .first()
    .waitFor();
});

it("makes the pictures of frames", async () => {
  const { page } = editor;
  const input = { file: `${root}examples/bunny-frame.pwf` };
  await editor.loopback.ask("open", { design: { input, units: "mm" } });
  await editor.reload("frame");
  const frame = editor.section("frame");
  await frame.getByLabel("Material").selectOption("abs-1-5mm");
  await frame.getByRole("button", { name: "Compute", exact: true }).click();
  await frame.getByRole("table", { name: "Results" }).waitFor();
  await picture("frame");
  await frame.getByRole("list", { name: "Modes" }).getByRole("button").first().click();
  await page
    .getByRole("region", { name: "Legend" })
    .getByText(/^Mode 1, /)
    .waitFor();
  await picture("mode");

  await editor.reload("sequence");
  const sequence = editor.section("sequence");
  await sequence.getByRole("button", { name: "Find", exact: true }).click();
  const slider = page.getByLabel("Position in the sequence");
  await until(async () => Number(await slider.getAttribute("max"))).toBeGreaterThan(100);
  await slider.fill("90");
  await page
    .getByRole("region", { name: "Timeline" })
    .getByText(/^step 9[01] /)
    .waitFor();
  await picture("sequence");
  await sequence.getByText(/^Colours of the layers/).click();
  await slider.fill(String(await slider.getAttribute("max")));
  await picture("layers");
});

it("makes the pictures of closed joints", async () => {
  const { page } = editor;
  await editor.take("truss", "frame");
  const frame = editor.section("frame");
  const legend = page.getByRole("region", { name: "Legend" });
  await frame.getByText("Free", { exact: true }).click();
  await frame.getByLabel("Material").selectOption("steel-0-9mm");
  await frame.getByText(/close their joints/).click();
  await frame.getByText(/^Run wires along edges twice/).click();
  await frame.getByRole("button", { name: "Compute", exact: true }).click();
  const closed = frame.getByRole("table", { name: "Closed frame" });
  await closed.waitFor();
  for (const shape of ["As made", "As closed"]) {
    await frame.getByText(shape, { exact: true }).first().click();
    await legend.getByText(shape).waitFor();
    await closed.scrollIntoViewIfNeeded();
    await picture(shape.toLowerCase().replace(" ", "-"));
  }
  await page.keyboard.press("Escape");
  const force = frame.getByLabel("Force", { exact: true });
  await force.fill("20");
  await force.press("Enter");
  await frame.getByRole("button", { name: "Find the tolerance" }).click();
  const tolerance = frame.getByRole("table", { name: "Tolerance" });
  await tolerance.getByText(/which governs/).waitFor();
  await tolerance.scrollIntoViewIfNeeded();
  await picture("tolerance");
});
