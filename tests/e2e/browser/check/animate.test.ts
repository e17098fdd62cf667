import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;

beforeAll(async () => {
  editor = await Editor.open();
  // How often the view is drawn: each picture begins with clearing.
  await editor.page.addInitScript(() => {
    const counting = window as unknown as { drawn: number };
    counting.drawn = 0;
    const { clear } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.clear = function (mask) {
      counting.drawn += 1;
      clear.call(this, mask);
    };
  });
  await editor.take("house", "animate");
});
afterAll(() => editor?.end());

const animate = () => editor.section("animate");
const percent = async () => Number.parseFloat(await animate().locator(".animate-figures > span").first().innerText());
const drawn = () => editor.page.evaluate(() => (window as unknown as { drawn: number }).drawn);
const slider = () => animate().getByLabel("Position in the program");

/** "1:09" of seconds. */
const clock = (seconds: number) =>
  `${Math.floor(Math.round(seconds) / 60)}:${String(Math.round(seconds) % 60).padStart(2, "0")}`;

/** So many pictures of the screen later. */
const frames = (count: number) =>
  editor.page.evaluate(
    (count) =>
      new Promise<void>((done) => {
        const next = (left: number) => (left === 0 ? done() : void requestAnimationFrame(() => next(left - 1)));
        next(count);
      }),
    count,
  );

it("makes the program of the design by itself, and plays, holds, steps, slides and goes back", async () => {
  await animate().getByRole("listbox", { name: "Steps" }).waitFor();
  const { wires } = await editor.loopback.ask("program", {});
  expect(await animate().getByRole("option").count()).toBe(wires[0]?.steps.length);
  await animate().getByRole("button", { name: "Play" }).click();
  await until(percent).toBeGreaterThan(1);
  await animate().getByRole("button", { name: "Pause" }).click();
  const held = await slider().inputValue();
  await frames(20);
  expect(await slider().inputValue()).toBe(held);
  await animate().getByRole("button", { name: "Step forward" }).click();
  await until(() => slider().inputValue()).toBe(String(Math.floor(Number(held)) + 1));
  await animate().getByRole("button", { name: "Step back" }).click();
  await until(() => slider().inputValue()).toBe(String(Math.floor(Number(held))));
  await slider().fill("3.5");
  await until(percent).toBe(70);
  await animate().getByRole("option", { selected: true }).filter({ hasText: /^4/ }).waitFor();
  await animate().getByRole("button", { name: "Go to start" }).click();
  await until(percent).toBe(0);
});

it("draws nothing while nothing plays", async () => {
  await frames(10);
  const before = await drawn();
  await frames(40);
  expect(await drawn()).toBe(before);
  await animate().getByRole("button", { name: "Play" }).click();
  await until(drawn).toBeGreaterThan(before + 5);
  await animate().getByRole("button", { name: "Pause" }).click();
});

it("says how long it plays at the speeds that are set", async () => {
  const { wires } = await editor.loopback.ask("program", {});
  const steps = wires[0]?.steps ?? [];
  const part = (k: number) => steps.reduce((all, { seconds }) => all + (seconds[k] ?? 0), 0);
  const [feed, rotate, bend, wait] = [part(0), part(1), part(2), part(3)];
  const set = async (name: string, value: number) => {
    const field = animate().getByLabel(`${name} × speed`);
    await field.fill(String(value));
    await field.press("Enter");
  };
  const said = () =>
    animate()
      .getByText(/^plays in/)
      .innerText();
  await set("Bend", 1);
  await until(said).toBe(`plays in ${clock(feed + rotate + bend + wait)}`);
  await set("Feed", 2);
  await set("Rotate", 5);
  await set("Bend", 10);
  // The peg comes out and goes in for bends: that is played as fast as they are.
  await until(said).toBe(`plays in ${clock(feed / 2 + rotate / 5 + (bend + wait) / 10)}`);
  await set("All", 4);
  await until(said).toBe(`plays in ${clock((feed / 2 + rotate / 5 + (bend + wait) / 10) / 4)}`);
});

it("says how far the made wire is from the designed one, as the machine bends it", async () => {
  await animate().getByText("As made", { exact: true }).click();
  const { wires, by_machine } = await editor.loopback.ask("made", {});
  expect(by_machine).toBe(true);
  const worst = (wires[0]?.worst_mm ?? NaN).toFixed(2);
  await animate()
    .getByText(new RegExp(`${worst.replace(".", "\\.")}.mm.*, on the simulated machine`))
    .waitFor();
  await animate().getByText("Both", { exact: true }).click();
  await editor.isClean("animate");
  await animate().getByRole("button", { name: "Back to the design" }).click();
});

it("shows how far off vertices come out while the wire is played", async () => {
  const shown = animate().getByRole("checkbox", { name: "Accuracy" });
  expect(await shown.isDisabled()).toBe(true);
  await animate().getByRole("button", { name: "Predict" }).click();
  const line = animate().getByText(/^Worst vertex: 95 % within/);
  await line.waitFor();
  // Asked any earlier, this would be asked in place of what the window has asked.
  const { found } = await editor.loopback.ask("predict", { noise: "wirebend-kit", runs: 2000, seed: 1, within_mm: 1 });
  const worst = found?.wires[0]?.worst_radius_95_mm ?? NaN;
  expect(Number.parseFloat((await line.innerText()).split("within")[1] ?? "")).toBeCloseTo(worst, 2);
  await slider().fill("4.6");
  expect(await shown.isChecked()).toBe(true);
  await editor.isClean("animate-accuracy");
  await shown.uncheck();
  await editor.isClean("animate-no-accuracy");
  await animate().getByRole("button", { name: "Back to the design" }).click();
});

it("plays to its end and stands there, and says when the design is another one", async () => {
  await slider().fill("4.6");
  await animate().getByRole("button", { name: "Play" }).click();
  await until(percent).toBe(100);
  await animate().getByRole("button", { name: "Play" }).waitFor();
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("Escape");
  await editor.page.keyboard.press("a");
  for (const key of ["g", "x", "5", "Enter"]) await editor.page.keyboard.press(key);
  // Left alone for a moment it is made anew by itself.
  await until(async () => (await editor.design()).state.undo).not.toBeNull();
  const { wires } = await editor.loopback.ask("program", {});
  await until(() => editor.phrase("animate")).toContain(clock(wires[0]?.time_s ?? NaN));
});
