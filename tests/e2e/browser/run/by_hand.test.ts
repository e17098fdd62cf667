import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  await editor.take("house", "run");
});
afterAll(() => editor?.end());

const run = () => editor.section("run");
const button = (name: string | RegExp) =>
  run().getByRole("button", typeof name === "string" ? { name, exact: true } : { name });
const press = (key: string) => editor.page.keyboard.press(key);
const state = () => editor.machine();
/** Until it stands so and is done with its order, also in the window. */
const rests = async (phase: string) => {
  await until(async () => {
    const now = await state();
    return now.busy ? "busy" : now.phase;
  }).toBe(phase);
  await run().locator(`.run-phase.${phase}`).waitFor();
  await until(() => button("Disconnect").getAttribute("aria-disabled")).toBeNull();
};
const places = async () => {
  const { position } = await state();
  return [position?.feed_mm, position?.bend_deg, position?.rotate_deg].map((value) => Math.round((value ?? NaN) * 10));
};

it("moves by keys only while the button for it is on, by the step that is shown", async () => {
  await run().getByLabel("Port", { exact: true }).selectOption("sim:max");
  await button("Connect").click();
  await rests("connected");
  await button("Home").click();
  await rests("ready");
  await button("Record").click();
  const keys = button("Jog with keys");
  await run().getByText("Fine", { exact: true }).click();
  await keys.focus();
  // Of no effect while it is off: it would be the first of the moves that are recorded.
  await press("ArrowUp");
  await press("Space");
  await run().getByText("Keys move the machine. Esc ends it.").waitFor();
  await run().getByText("feed by 0.1 mm", { exact: false }).waitFor();
  const moves = [
    ["ArrowRight", "Feed 0.1 mm"],
    ["ArrowUp", "Bend 0.5°"],
    ["PageUp", "Rotate 0.5°"],
    ["ArrowDown", "Bend −0.5°"],
    ["+", null],
    ["ArrowRight", "Feed 1.0 mm"],
  ] as const;
  const made: string[] = [];
  for (const [key, move] of moves) {
    await press(key);
    if (move === null) {
      await run().getByText("feed by 1.0 mm", { exact: false }).waitFor();
      continue;
    }
    made.push(move);
    await until(async () => (await state()).recorded).toBe(made.length);
    await rests("ready");
  }
  await until(() => run().locator(".recorded li").allInnerTexts()).toEqual(made);
  expect(await places()).toEqual([11, 0, 5]);
  await editor.isCleanNow("by-hand-keys");
  // The focus elsewhere, and keys are for something else.
  await run().getByLabel("Feed by, mm").focus();
  await run().getByText("Off: keys do not move the machine.").waitFor();
  await press("ArrowUp");
  // It has stepped the field, and moved nothing: the next move that is recorded is that of the button.
  await button("Feed 2.0 mm").click();
  made.push("Feed 2.0 mm");
  await until(() => run().locator(".recorded li").allInnerTexts()).toEqual(made);
  await rests("ready");
  expect(await places()).toEqual([31, 0, 5]);
});

it("replays what was just recorded from the reference, once a person has said that it may move", async () => {
  await button("Home").click();
  await rests("ready");
  await button("Clear").first().click();
  await until(async () => (await state()).recorded).toBe(0);
  await run().getByText("Coarse", { exact: true }).click();
  const [from = 0] = await places();
  for (const [name, recorded] of [
    ["Feed 10.0 mm", 1],
    ["Rotate 90.0°", 2],
  ] as const) {
    await button(name).click();
    await until(async () => (await state()).recorded).toBe(recorded);
    await rests("ready");
  }
  expect(await places()).toEqual([from + 100, 0, 900]);
  await button("Replay").click();
  const asks = editor.page.getByRole("dialog");
  await asks.getByText("Moves: feed 10 mm, rotate 90°").waitFor();
  expect(await places()).toEqual([from + 100, 0, 900]);
  await asks.getByRole("button", { name: "Move", exact: true }).click();
  // The same feed once more; the head at 90° once more, and not at 180°.
  await until(async () => (await places())[0]).toBe(from + 200);
  await rests("ready");
  expect(await places()).toEqual([from + 200, 0, 900]);
  expect((await state()).recorded).toBe(2);
});

it("makes a dry run of the wire, which is none of what is recorded, and leaves the bend axis at zero", async () => {
  await button("Home").click();
  await rests("ready");
  const [from = 0] = await places();
  const { recorded } = await state();
  expect(await button("Dry run…").getAttribute("title")).toMatch(/without wire and with the peg in/);
  await button("Dry run…").click();
  await editor.page.getByRole("dialog").getByText(/wire/).first().waitFor();
  await editor.isCleanNow("by-hand-dry-run");
  await editor.page.getByRole("dialog").getByRole("button", { name: "Move", exact: true }).click();
  // The house takes several times as much wire.
  await until(async () => ((await places())[0] ?? 0) > from + 500).toBe(true);
  await rests("ready");
  expect((await places())[1]).toBe(0);
  expect((await state()).recorded).toBe(recorded);
  await until(() => button("Arm…").getAttribute("aria-disabled")).toBeNull();
});

it("says in the console when each line went over the wire", async () => {
  await button(/^Console/).click();
  const lines = run().getByRole("log", { name: "Lines to and from the machine" }).locator("time");
  await until(() => lines.count()).toBeGreaterThan(10);
  const times = await lines.allInnerTexts();
  expect(times.every((text) => /^\d\d:\d\d:\d\d\.\d{3}$/.test(text))).toBe(true);
  expect(times.toSorted()).toEqual(times);
  await editor.isClean("by-hand-console");
});

it("takes lines for the machine, whose answers stand below them, and none while a wire is armed", async () => {
  const field = run().getByLabel("Line to the machine");
  const log = run().getByRole("log", { name: "Lines to and from the machine" });
  const typed = async (line: string, answer: RegExp) => {
    await field.fill(line);
    await field.press("Enter");
    await log.getByText(answer).last().waitFor();
    await rests("ready");
  };
  await typed("C4", /v4,/);
  await typed("status", /t0,/);
  // The field is still there to be typed in, and has what was typed before.
  expect(await field.inputValue()).toBe("");
  await field.press("ArrowUp");
  await field.press("ArrowUp");
  expect(await field.inputValue()).toBe("C4");
  // What is refused stays to be corrected, and the log says why.
  await typed("M1,100,0,0", /Not sent: M1,100,0,0\. .*numbers the lines that move the machine/);
  await until(() => field.inputValue()).toBe("M1,100,0,0");
  await editor.isCleanNow("by-hand-typed");
  // What is stored needs homing afterwards.
  await field.fill("W4,5999");
  await field.press("Enter");
  await rests("connected");
  await button("Home").click();
  await rests("ready");
  await button("Arm…").click();
  await editor.page.getByRole("dialog").getByRole("button", { name: "Arm", exact: true }).click();
  await run().locator(".run-phase.armed").waitFor();
  await until(() => field.getAttribute("placeholder")).toMatch(/armed/);
  expect(await field.isEditable()).toBe(false);
  await button("Disarm").click();
  await rests("ready");
});

it("makes a design of what was just recorded: the shape that the moves leave", async () => {
  await button("Clear").first().click();
  await until(async () => (await state()).recorded).toBe(0);
  // Longer than the machine's shortest edge: nearer to the end of the wire its peg touches none.
  await run().getByLabel("Feed by, mm").fill("60");
  await run().getByLabel("Feed by, mm").press("Tab");
  for (const [name, recorded] of [
    ["Feed 60.0 mm", 1],
    ["Bend 45.0°", 2],
    ["Feed 60.0 mm", 3],
  ] as const) {
    await button(name).click();
    await until(async () => (await state()).recorded).toBe(recorded);
    await rests("ready");
  }
  await button("Make it a design…").click();
  const dialog = editor.page.getByRole("dialog");
  // As the button says; the other way is there too.
  await until(() => dialog.getByRole("radio", { name: /^Make it a design/ }).isChecked()).toBe(true);
  await editor.isCleanNow("by-hand-design");
  await dialog.getByRole("button", { name: "Open", exact: true }).click();
  await until(async () => (await editor.design()).edges.length).toBe(2);
  const [first = [], corner = [], last = []] = (await editor.design()).vertices.map(({ at_mm }) => at_mm);
  const apart = (a: readonly number[], b: readonly number[]) => Math.hypot(...a.map((value, k) => value - (b[k] ?? 0)));
  // As much as was fed, but for the corner, which is farther out than the arc; and bent, by less than 45°, since the wire springs back.
  for (const side of [apart(first, corner), apart(corner, last)]) expect(Math.abs(side - 60)).toBeLessThan(1);
  const across = apart(first, last);
  expect(across).toBeLessThan(119);
  expect(across).toBeGreaterThan(120 * Math.cos(Math.PI / 8));
});
