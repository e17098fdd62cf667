import { readFileSync, writeFileSync } from "node:fs";
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
const dialog = () => editor.page.getByRole("dialog");
const state = () => editor.machine();
/** Until the window says that the machine stands so, and is done with its order. */
const stands = async (phase: string) => {
  await run().locator(`.run-phase.${phase}`).waitFor();
  if (phase !== "making" && phase !== "holding") await until(async () => (await state()).busy).toBe(false);
};
/** Until all is reported of what the machine did before it held: two looks in a row find it at the same place. */
const atRest = async () => {
  let before = "";
  await until(async () => {
    const { position, wire } = await state();
    const now = JSON.stringify([position, wire?.made]);
    const same = now === before;
    before = now;
    return same;
  }).toBe(true);
};
/**
 * Until the machine is there, resuming where it holds by itself: at ten times the speed it takes a tenth of a second in which this computer
 * was busy for a cable that was cut.
 */
const goingOn = (there: () => Promise<boolean>) =>
  until(async () => {
    if (await there()) return true;
    if ((await state()).phase === "holding")
      await button("Resume")
        .click({ timeout: 1000 })
        .catch(() => undefined);
    return false;
  }).toBe(true);
const isMade = () =>
  run()
    .getByText(/^The wire is finished, in/)
    .isVisible();

async function connect(port: string): Promise<void> {
  await run().getByLabel("Port", { exact: true }).selectOption(port);
  await button("Connect").click();
  await stands("connected");
}

async function arm(): Promise<void> {
  await button("Arm…").click();
  await dialog().getByRole("button", { name: "Arm", exact: true }).click();
  await stands("armed");
}

/** Whether a button of the section is in sight, and no part of it beyond the edge of the panel or behind something else. */
const isWhole = (name: string): Promise<boolean> =>
  button(name).evaluate((one) => {
    const { left, right, top, bottom } = one.getBoundingClientRect();
    const corners = [top + 2, bottom - 2].flatMap((y) => [left + 4, right - 4].map((x) => [x, y] as const));
    return corners.every(([x, y]) => one.contains(document.elementFromPoint(x, y)));
  });

/** Per cent: at ten times the speed the house takes half a minute then. */
const SLOW = 20;

/** How a machine stands that resumes a wire, or is done with it. */
const GONE_ON: ReadonlySet<string> = new Set(["making", "holding", "ready"]);

/** Answers what is asked before an interrupted wire resumes: nothing of the steps in doubt was done. */
async function goOn(): Promise<void> {
  await button("Resume…").click();
  await until(async () => GONE_ON.has((await state()).phase) || (await state()).question !== null).toBe(true);
  for (;;) {
    const { question, phase } = await state();
    if (!question) {
      if (GONE_ON.has(phase)) return;
      await until(async () => (await state()).question !== null || GONE_ON.has((await state()).phase)).toBe(true);
      continue;
    }
    if (question.kind === "doubt") await dialog().getByText("None of it", { exact: true }).click();
    const yes = question.kind === "doubt" ? "Continue" : "Resume";
    await dialog().getByRole("button", { name: yes, exact: true }).click();
    await until(async () => (await state()).question?.id !== question.id).toBe(true);
  }
}

it("connects the simulated machine, and says why the rest has to wait", async () => {
  await button("Connect").waitFor();
  expect(await editor.page.locator(".stop-button").getAttribute("aria-disabled")).toBe("true");
  await connect("sim:max");
  await run().getByText("WireBend-kit · simulated").waitFor();
  expect(await button("Start").getAttribute("title")).toBe("Arm the machine first.");
  expect(await button("Feed 10.0 mm").getAttribute("title")).toBe("Home the machine first.");
  expect(await editor.page.locator(".stop-button").getAttribute("aria-disabled")).toBeNull();
});

it("homes, and moves by hand with the place that it reports", async () => {
  await button("Home").click();
  await stands("ready");
  // What leads on from here is in sight as a whole in a window of 1280 by 800.
  await until(() => isWhole("Arm…")).toBe(true);
  expect(await isWhole("Start")).toBe(true);
  await button("Record").click();
  const feed = run().getByLabel("Feed by, mm");
  await feed.fill("12.5");
  await feed.press("Tab");
  for (const [name, axis] of [
    ["Feed 12.5 mm", 0],
    ["Rotate 90.0°", 2],
    ["Bend 45.0°", 1],
  ] as const) {
    await button(name).click();
    // One after the other: the place is that of a machine at rest.
    await until(async () => (await state()).recorded).toBe([0, 2, 1].indexOf(axis) + 1);
    await stands("ready");
  }
  await until(() => run().locator(".manual-at").allInnerTexts()).toEqual(["at 12.5 mm", "at 0.0°", "at 90.0°"]);
  await button("Rotate −90.0°").click();
  await until(() => run().locator(".manual-at").allInnerTexts()).toEqual(["at 12.5 mm", "at 0.0°", "at 0.0°"]);
  await stands("ready");
});

it("shows what goes over the line both ways, filters it and clears it", async () => {
  await run()
    .getByRole("button", { name: /^Console/ })
    .click();
  const log = run().getByRole("log", { name: "Lines to and from the machine" });
  for (const way of ["to the machine", "from the machine"]) await log.getByRole("img", { name: way }).first().waitFor();
  await run().getByLabel("Filter lines").fill("no machine says this");
  await log.getByText("No line fits the filter.").waitFor();
  await run().getByLabel("Filter lines").fill("");
  await editor.isCleanNow("run-console");
  await run().getByRole("button", { name: "Clear", exact: true }).last().click();
  await log.getByText("No messages yet.").waitFor();
  await run()
    .getByRole("button", { name: /^Console/ })
    .click();
});

it("keeps what was moved, writes it, and replays it", async () => {
  await until(() => run().locator(".recorded li").allInnerTexts()).toEqual([
    "Feed 12.5 mm",
    "Rotate 90.0°",
    "Bend 45.0°",
    "Rotate −90.0°",
  ]);
  await button("Save…").click();
  const file = await run().locator(".written .selectable").innerText();
  await editor.isCleanNow("run-recorded");
  await button("Clear").click();
  await button("Home").click();
  await stands("ready");
  await editor.choose(file, () => button("Replay a file…").click());
  // What the file holds is read before it moves anything.
  await dialog().getByText("Moves: feed 12.5 mm, rotate 90°, bend 45°, rotate -90°").waitFor();
  await dialog().getByRole("button", { name: "Move", exact: true }).click();
  await until(async () => (await state()).position?.feed_mm.toFixed(1)).toBe("25.0");
  await stands("ready");

  // The same moves of another machine: they run only when a person confirms it once more.
  const moves = readFileSync(file, "utf8");
  expect(moves).toContain('"wirebend-kit"');
  writeFileSync(file, moves.replace('"wirebend-kit"', '"grbl-bender"'));
  await editor.choose(file, () => button("Replay a file…").click());
  const asks = run().getByRole("group", { name: "Moves of another machine" });
  await asks.waitFor();
  await editor.isCleanNow("run-foreign-moves");
  expect((await state()).position?.feed_mm.toFixed(1)).toBe("25.0");
  await asks.getByRole("button", { name: "Replay anyway" }).click();
  await dialog().getByRole("button", { name: "Move", exact: true }).click();
  await until(async () => (await state()).position?.feed_mm.toFixed(1)).toBe("37.5");
  await asks.waitFor({ state: "detached" });
  await stands("ready");
  await button("Record").click();
});

it("arms with a summary, starts, shows the steps, pauses and resumes", async () => {
  await button("Arm…").click();
  const lines = await dialog().locator(".question-lines").innerText();
  const { wires } = await editor.loopback.ask("program", {});
  const stock = Math.ceil(wires[0]?.stock_mm ?? NaN);
  expect(lines).toContain(`${wires[0]?.steps.length} steps`);
  expect(lines).toContain(`at least ${stock} mm of Aluminium`);
  await editor.isClean("run-arm");
  // Esc is no answer to whether a machine may move.
  await editor.page.keyboard.press("Escape");
  expect(await dialog().isVisible()).toBe(true);
  await dialog().getByRole("button", { name: "Do not arm" }).click();
  await stands("ready");
  await button("Disconnect").click();
  await connect("sim:10");
  await arm();
  await button("Start").click();
  await editor.atSpeed(SLOW);
  await stands("making");
  const shown = editor.page.locator(".timeline-step");
  // Its wire is seen while it comes out, and not only when the first step is done.
  await shown.filter({ hasText: /^bending · step 1 \/ 5 · [1-9]/ }).waitFor();
  // Its record is no interrupted one: the machine is at it.
  const runs = () => run().locator(".fold", { hasText: /^Runs/ });
  await runs().locator(".fold-head").click();
  await runs()
    .getByText(/^(being bent|paused): \d of 5 steps done/)
    .waitFor();
  expect(await runs().getByText("interrupted after").count()).toBe(0);
  await runs().locator(".fold-head").click();
  // It may hold by itself before.
  await until(async () => {
    if ((await state()).phase === "making")
      await button("Pause")
        .click({ timeout: 1000 })
        .catch(() => undefined);
    return (await state()).phase;
  }).toBe("holding");
  await run()
    .locator(".run-phase.holding", { hasText: /^paused$/ })
    .waitFor();
  await shown.filter({ hasText: /^paused · step/ }).waitFor();
  await atRest();
  const held = await state();
  await editor.isCleanNow("run-holding");
  const { wire, position } = await state();
  expect([wire?.made, position]).toEqual([held.wire?.made, held.position]);
  // As slow as is wanted, and no faster than its settings say.
  await editor.atSpeed(100);
  const speed = run().getByRole("group", { name: "Speed" });
  await speed.getByRole("button", { name: "Faster" }).click();
  await editor.messages.filter({ hasText: "goes no faster than its settings say" }).waitFor();
  for (const percent of [90, 80]) {
    await speed.getByRole("button", { name: "Slower" }).click();
    await speed.getByText(`${percent} %`, { exact: true }).waitFor();
  }
  await editor.isCleanNow("run-slower");
  await speed.getByRole("button", { name: "100 %" }).click();
  await until(async () => (await state()).speed_percent).toBe(100);
  await editor.atSpeed(SLOW);
  await goingOn(async () => ((await state()).wire?.made ?? 0) > (held.wire?.made ?? 0));
});

it("stops by the button, at once, and shows what is known of the wire", async () => {
  await editor.page.locator(".top-bar .stop-button").click();
  await stands("stopped");
  const { unfinished } = await state();
  expect(unfinished).toMatchObject({ name: "House", of: 5 });
  await run().getByRole("group", { name: "Interrupted wire" }).getByText(`of 5 is done`).waitFor();
  await editor.isClean("run-stopped");
});

it("resumes after a stop, is stopped once more by the key, and finishes the wire in the end", async () => {
  await goOn();
  await editor.atSpeed(SLOW);
  // Whatever has the focus: also a field.
  const field = run().getByLabel("Feed by, mm");
  const typed = await field.inputValue();
  await field.focus();
  await editor.page.keyboard.press("Control+Space");
  await stands("stopped");
  expect(await field.inputValue()).toBe(typed);
  await button("Disconnect").click();
  await run().locator(".section-phrase", { hasText: "not connected" }).waitFor();
  // It is resumed at the machine where it was begun.
  await connect("sim:10");
  await goOn();
  await goingOn(isMade);
  await stands("ready");
  expect((await state()).unfinished).toBeNull();
});

it("bends a wire from the first step to the last, and keeps a record of it", async () => {
  await button("Disconnect").click();
  await connect("sim:max");
  await arm();
  await button("Start").click();
  await run()
    .getByText(/^The wire is finished, in/)
    .waitFor();
  await stands("ready");
  const { runs } = await editor.loopback.ask("runs", {});
  const worst = runs.at(-1)?.worst_deviation_mm?.toFixed(2);
  await run().getByText(`Worst vertex ${worst} mm from the design.`).waitFor();
  await run().getByRole("button", { name: /^Runs/ }).click();
  const [first, second] = await run().locator(".fold", { hasText: "Runs" }).locator(".line").allInnerTexts();
  expect(first).toMatch(new RegExp(`House[^]*5 steps done · worst vertex ${worst} mm`));
  expect(second).toMatch(/5 steps done[\s\S]*2 interruptions/);
  await editor.isCleanNow("run-made");
});

async function giveUp(): Promise<void> {
  await button("Give up…").click();
  await button("Give it up").click();
  await run().getByRole("group", { name: "Interrupted wire" }).waitFor({ state: "detached" });
}

it("asks how much of a step is in the wire that was stopped in its feed, and finishes it", async () => {
  await button("Disconnect").click();
  // Two metres are fed first, long enough to be met in it; a shorter feed is met in real time only, in which homing takes half a minute.
  const bytes = [...Buffer.from("v 0 0 0\nv 2000 0 0\nv 4000 200 0\nl 1 2 3\n")];
  await editor.loopback.ask("open", { design: { input: { bytes: { name: "long.obj", bytes } }, units: "mm" } });
  await editor.reload("run");
  await connect("sim:10");
  await arm();
  await button("Start").click();
  await until(async () => {
    const { phase, position } = await state();
    return phase === "making" && (position?.feed_mm ?? 0) > 3;
  }).toBe(true);
  await editor.page.keyboard.press("Control+Space");
  await stands("stopped");
  expect((await state()).unfinished).toMatchObject({ made: 0, in_doubt: [1, 1] });
  await button("Resume…").click();
  await dialog().getByRole("heading", { name: "Look at the wire" }).waitFor();
  const counted = (await state()).question?.doubt?.counted;
  const whole = (await state()).question?.doubt?.told.feed_mm ?? NaN;
  expect(counted?.feed_mm).toBeGreaterThan(3);
  expect(counted?.feed_mm).toBeLessThan(whole);
  // The wire is seen with what is done of the step.
  await editor.page.locator(".timeline-step", { hasText: /step 1 \/ 2/ }).waitFor();
  await dialog().getByText("Measured", { exact: true }).click();
  await dialog().getByText("How to check").click();
  await editor.isClean("run-doubt");
  // It counts while it is typed: nobody has to leave the field first.
  await dialog().getByLabel("Fed, mm").fill("5.5");
  await dialog()
    .getByText(`The machine will do: feed ${(whole - 5.5).toFixed(1).replace(/^(\d)(\d{3})/, "$1\u202f$2")} mm`)
    .waitFor();
  const go = dialog().getByRole("button", { name: "Continue", exact: true });
  await until(() => go.getAttribute("aria-disabled")).toBeNull();
  await dialog().getByLabel("Fed, mm").fill("5.5 of it");
  await until(() => go.getAttribute("title")).toBe("Type what you measure.");
  await dialog().getByText("As counted", { exact: true }).click();
  await dialog().getByText("may have lost steps as it stopped").waitFor();
  await dialog().getByRole("button", { name: "Continue", exact: true }).click();
  await dialog().getByText("Step 1 was stopped in its middle").waitFor();
  await editor.isCleanNow("run-rest");
  await dialog().getByRole("button", { name: "Resume", exact: true }).click();
  await until(async () => (await state()).phase).toBe("making");
  await editor.page.keyboard.press("Control+Space");
  await stands("stopped");
  await giveUp();
});

it("reports an interrupted wire after a crash, and gives it up when that is said twice", async () => {
  await button("Disconnect").click();
  await editor.take("house", "run");
  await connect("sim:10");
  await arm();
  await button("Start").click();
  await editor.atSpeed(SLOW);
  await editor.page.keyboard.press("Control+Space");
  await stands("stopped");

  // What is known of it outlives the program, and is shown before a machine is connected.
  await editor.crash();
  await editor.take("house", "run");
  await run().getByText("A wire was interrupted").waitFor();
  await editor.isCleanNow("run-interrupted");
  await connect("sim:10");
  await giveUp();
  await until(async () => (await editor.loopback.ask("runs", {})).runs.at(-1)?.outcome).toBe("abandoned");
  await editor.isClean("run");
});
