import { afterAll, beforeAll, expect, it } from "vitest";
import type { Order } from "../../../../ui/src/generated/requests.ts";
import { picture } from "../../support/browser.ts";
import { Editor, until } from "../../support/editor.ts";
import { type Place, Sight } from "../../support/sight.ts";
import { holdsStill } from "../../support/still.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const press = (key: string) => editor.page.keyboard.press(key);
const canvas = () => editor.page.locator(".viewport canvas");
const selected = () => editor.section("edit").locator("p[role=status]").innerText();
const menu = () => editor.page.getByRole("menu");
const edges = async () => (await editor.design()).edges.length;

const CORNER: Place = [35, 0, 0];

/** Turns to the front of the house. */
const front = () => Sight.front(editor);

it("keeps the layout while things are selected, moved, undone and played", async () => {
  await editor.take("house", "edit", "check");
  // Until what the checks say of it is known, with what can be done about it.
  await editor.section("check").getByRole("button", { name: "Fix…" }).waitFor();
  const sight = await front();
  const { mouse } = editor.page;
  const { x, y } = sight.at(CORNER);
  await holdsStill(
    editor.page,
    "selecting a vertex",
    () => mouse.click(x, y),
    () => until(selected).toBe("1 vertex · 0 edges"),
  );
  await holdsStill(
    editor.page,
    "selecting everything",
    () => press("a"),
    () => until(selected).toMatch(/^6 vertices/),
  );
  await holdsStill(
    editor.page,
    "selecting nothing",
    () => press("Escape"),
    () => until(selected).toMatch(/^Nothing/),
  );
  // What the checks say is longer or shorter then: the sections below Edit follow them, and nothing else.
  await mouse.click(x, y);
  for (const key of ["g", "x"]) await press(key);
  await holdsStill(
    editor.page,
    "a move, which changes the design for the first time",
    async () => {
      for (const key of ["5", "Enter"]) await press(key);
    },
    () => editor.page.getByTitle("Unsaved changes").waitFor(),
    "#section-check, #section-check ~ *",
  );
  await holdsStill(
    editor.page,
    "undo",
    () => press("Control+z"),
    () => until(async () => (await editor.vertex(1))[0]).toBe(35),
    "#section-check, #section-check ~ *",
  );
  await editor.section("check").getByRole("button", { name: "Fix…" }).waitFor();
  const program = editor.page.locator(".timeline input[type=range]:enabled");
  await canvas().focus();
  await holdsStill(
    editor.page,
    "playing",
    () => press("Space"),
    () => program.waitFor(),
  );
  await editor.button("Back to the design").waitFor();
  await holdsStill(
    editor.page,
    "going back to the design",
    () => press("Escape"),
    () => editor.button("Back to the design").waitFor({ state: "detached" }),
  );
});

it("keeps the view where it is when the first edge is drawn, and when a program comes of it", async () => {
  await editor.take(null, "trace", "edit");
  await holdsStill(
    editor.page,
    "taking the tool",
    () => press("d"),
    () => editor.section("trace").getByText("Click on the plane to begin a strand").waitFor(),
    ".start, .empty",
  );
  const box = await canvas().boundingBox();
  const [x, y] = [(box?.x ?? 0) + 300, (box?.y ?? 0) + 300];
  await holdsStill(
    editor.page,
    "drawing the first edge",
    async () => {
      for (const dx of [0, 150]) {
        await editor.page.mouse.move(x + dx - 4, y);
        await editor.page.mouse.move(x + dx, y, { steps: 3 });
        await editor.page.mouse.click(x + dx, y);
      }
    },
    () => until(edges).toBe(1),
    // The table of vertices is as long as there are some.
    ".start, .empty, .strand, #section-edit, #section-edit ~ *",
  );
  await press("Escape");
});

it("previews a fix over the view, so that the fixes stay under the pointer", async () => {
  await editor.take("bunny", "check");
  const check = editor.section("check");
  await check.getByRole("button", { name: "Fix…" }).first().click();
  const previews = check.getByRole("button", { name: "Preview" });
  await previews.first().waitFor();
  await editor.page.mouse.move(400, 400);
  const figures = editor.page.getByRole("region", { name: "Before and after the fix" });
  await holdsStill(
    editor.page,
    "a preview",
    () => previews.first().click(),
    () => figures.waitFor(),
  );
  await picture(editor.page, "still-preview");
  await holdsStill(
    editor.page,
    "another preview",
    () => previews.nth(1).click(),
    () => until(() => previews.nth(1).getAttribute("aria-pressed")).toBe("true"),
  );
  await editor.isCleanNow("still-previewed");
  await holdsStill(
    editor.page,
    "no preview",
    () => previews.nth(1).click(),
    () => figures.waitFor({ state: "detached" }),
  );
});

it("keeps the layout when messages come, go and are dismissed, three at a time", async () => {
  await editor.take("house", "edit");
  const drop = async (name: string) => {
    await editor.drop(name, "x");
    await editor.messages.filter({ hasText: name }).waitFor();
  };
  for (const name of ["one.nothing", "two.nothing", "three.nothing", "four.nothing"])
    await holdsStill(
      editor.page,
      `a message of ${name}`,
      () => drop(name),
      () => Promise.resolve(),
      ".problems",
    );
  expect(await editor.messages.count()).toBe(3);
  await editor.page.getByText("1 more").waitFor();
  await editor.isCleanNow("still-messages");
  const first = editor.messages.first();
  await first.hover();
  await holdsStill(
    editor.page,
    "dismissing the first message",
    () => first.getByRole("button", { name: "Dismiss" }).click(),
    () => editor.page.locator(".problem.gone").waitFor({ state: "attached" }),
    ".problem:first-child, .problems-all",
  );
  await holdsStill(
    editor.page,
    "dismissing all",
    () => editor.button("Dismiss all").click(),
    () => editor.button("Dismiss all").waitFor({ state: "detached" }),
    ".problems",
  );
});

it("keeps the layout around the panel while a machine is connected", async () => {
  await editor.take("house", "run");
  const run = editor.section("run");
  await until(() => editor.button("Connect").getAttribute("aria-disabled")).toBeNull();
  await holdsStill(
    editor.page,
    "connecting",
    () => editor.button("Connect").click(),
    () => run.locator(".run-phase.connected").waitFor(),
    ".panel-sections",
  );
  await until(() => editor.button("Disconnect").getAttribute("aria-disabled")).toBeNull();
  await holdsStill(
    editor.page,
    "disconnecting",
    () => editor.button("Disconnect").click(),
    () => editor.button("Connect").waitFor(),
    ".panel-sections",
  );
});

const run = () => editor.section("run");
const inRun = (name: string) => run().getByRole("button", { name, exact: true });
const phase = (name: string) => run().locator(`.run-phase.${name}`).waitFor();
const order = (what: Order) => editor.loopback.ask("order", { request: what });
const interrupted = () => run().getByRole("group", { name: "Interrupted wire" });

/** Per cent: a house that is bent at ten times the speed takes 70 s then, longer than a busy computer takes to look at all buttons. */
const SLOW = 10;

/** Starts the wire, and rests on the button meanwhile. */
async function starts(): Promise<void> {
  let slowed: Promise<void> | undefined;
  const start = async () => {
    await order({ order: "start" });
    slowed = editor.atSpeed(SLOW);
  };
  try {
    await rests("Start", start, "making", "Pause");
  } finally {
    await slowed;
  }
}

async function arm(): Promise<void> {
  await inRun("Arm…").click();
  await editor.page.getByRole("dialog").getByRole("button", { name: "Arm", exact: true }).click();
  await phase("armed");
}

/** Rests on a button while something else does it, and is on `then` afterwards. */
async function rests(name: string, does: () => Promise<unknown>, came: string, then: string): Promise<void> {
  await inRun(name).hover();
  const { x, y, width, height } = (await inRun(name).boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  await does();
  await phase(came);
  await editor.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const under = await editor.page.evaluate(
    ([x, y]) => document.elementFromPoint(x, y)?.closest("button")?.textContent?.trim() ?? "no button",
    [x + width / 2, y + height / 2] as const,
  );
  expect(under, `where ${name} was`).toBe(then);
}

it("keeps the buttons of Run under the pointer, whatever comes above them", async () => {
  await editor.take("house", "run");
  await run().getByLabel("Port", { exact: true }).selectOption("sim:10");
  await inRun("Connect").click();
  await phase("connected");
  await arm();
  await starts();
  await rests("Pause", () => order({ order: "pause" }), "holding", "Resume");
  await rests("Resume", () => order({ order: "resume" }), "making", "Pause");
  // A wire that is stopped leaves a card above.
  await rests("Pause", () => press("Control+Space"), "stopped", "Start");
  await interrupted().waitFor();
  await editor.isCleanNow("still-run-stopped");
});

it("keeps them there when the card of that wire goes, also where the panel has nothing to scroll", async () => {
  const size = editor.page.viewportSize() ?? { width: 1280, height: 800 };
  await editor.page.setViewportSize({ width: 1280, height: 1600 });
  await inRun("Home").click();
  await phase("ready");
  // Another wire: of the one that was interrupted nothing is forgotten.
  await editor.loopback.ask("edit", { request: { edit: "place", positions: [{ vertex: 1, at_mm: [40, 0, 0] }] } });
  await editor.reload("run");
  await interrupted().waitFor();
  await arm();
  expect(await run().evaluate((section) => section.closest(".panel-sections")?.scrollTop)).toBe(0);
  await starts();
  await interrupted().waitFor({ state: "detached" });
  await rests("Pause", () => press("Control+Space"), "stopped", "Start");
  await editor.page.setViewportSize(size);
});

it("keeps the focus on a click on a unit, and letters of a field away from the design", async () => {
  await editor.take("house", "edit");
  await canvas().focus();
  await press("a");
  await until(selected).toMatch(/^6 vertices/);
  const field = editor.page.getByLabel("Move by, X, mm");
  const unit = editor.section("edit").locator(".number-field", { has: field }).locator(".number-unit");
  await field.fill("12");
  await unit.click();
  await editor.page.keyboard.type("m");
  expect(await field.inputValue()).toBe("12m");
  await press("Escape");
  // After Tab, as well: the next thing is a button.
  await field.fill("12");
  for (const key of ["Tab", "Tab", "Tab", "m", "m", "Delete"]) await press(key);
  await editor.messages.filter({ hasText: "Click in the view to use its keys." }).waitFor();
  // Beside all fields: the focus is gone, and what was typed there is no order.
  await editor.section("edit").getByRole("heading", { name: "Vertices", exact: true }).click();
  for (const key of ["m", "x", "Delete", "s"]) await press(key);
  await editor.messages.filter({ hasText: "Click in the view to use its keys." }).waitFor();
  expect((await editor.design()).vertices).toHaveLength(6);
  expect((await editor.design()).state.undo).toBeNull();
  // The same where a click that takes no focus has closed the menu of a field; what only looks works.
  await field.click({ button: "right" });
  await menu().waitFor();
  // It hears clicks beside it from the first timer on that comes after it has the focus.
  const inMenu = () => document.activeElement?.closest("[role=menu]") != null;
  await until(() => editor.page.evaluate(inMenu)).toBe(true);
  await editor.page.evaluate(() => new Promise((done) => window.setTimeout(done)));
  await editor.section("edit").getByRole("heading", { name: "Vertices", exact: true }).click({ force: true });
  await menu().waitFor({ state: "detached" });
  await until(() => editor.page.evaluate(() => document.activeElement?.tagName)).not.toBe("INPUT");
  for (const key of ["m", "x", "Delete", "g", "e"]) await press(key);
  await press("n");
  await editor.page.locator(".viewport").getByText("60.0 mm", { exact: true }).first().waitFor();
  await press("n");
  expect((await editor.design()).vertices).toHaveLength(6);
  expect((await editor.design()).state.undo).toBeNull();
  // One click in the view, and they are its keys again.
  const sight = await front();
  const { x, y } = sight.at([35, 0, 30]);
  await editor.page.mouse.click(x, y);
  await press("s");
  await until(edges).toBe(7);
  await press("Control+z");
  await until(edges).toBe(6);
});
