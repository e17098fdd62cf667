import { afterAll, beforeAll, expect, it } from "vitest";
import { picture } from "../../support/browser.ts";
import { Editor, type Section, until } from "../../support/editor.ts";
import { atRest } from "../../support/still.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const SIZES = [
  { width: 1280, height: 800 },
  { width: 2560, height: 1440 },
] as const;
const THEMES = ["dark", "light"] as const;
const SECTIONS: readonly Section[] = [
  "parts",
  "trace",
  "edit",
  "check",
  "animate",
  "frame",
  "sequence",
  "machine",
  "export",
  "run",
];

/** Sections with a timeline under the view, or with most beside each other: these are seen in a large window too. */
const LARGE: ReadonlySet<Section> = new Set(["edit", "frame", "run"]);

/** What is wider than its place, or sticks out of the window. */
const outside = () =>
  editor.page.evaluate(() => {
    const found: string[] = [];
    const name = (element: Element) =>
      `<${element.tagName.toLowerCase()} class="${element.getAttribute("class") ?? ""}"> ${(element.textContent ?? "").trim().slice(0, 40)}`;
    const { innerWidth, innerHeight } = window;
    const root = document.documentElement;
    if (root.scrollWidth > innerWidth || root.scrollHeight > innerHeight) found.push("the window itself scrolls");
    for (const element of document.body.querySelectorAll("*")) {
      if (!(element instanceof HTMLElement) || element.closest(".visually-hidden, dialog:not([open])")) continue;
      const style = getComputedStyle(element);
      if (style.display === "none" || style.visibility === "hidden") continue;
      const box = element.getBoundingClientRect();
      if (box.width === 0 || box.height === 0) continue;
      // What scrolls by itself, and what ends in an ellipsis, is as wide as it should be.
      const scrolls = ["auto", "scroll"].includes(style.overflowX);
      const cut = style.textOverflow === "ellipsis" || style.overflowX === "clip";
      const field = element instanceof HTMLInputElement || element instanceof HTMLSelectElement;
      if (element.clientWidth > 0 && element.scrollWidth > element.clientWidth + 1 && !scrolls && !cut && !field)
        found.push(`too wide by ${element.scrollWidth - element.clientWidth}: ${name(element)}`);
      const inside = element.closest(".panel-sections, .rows, .popover, pre");
      if (box.right > innerWidth + 1 || box.left < -1 || (!inside && (box.bottom > innerHeight + 1 || box.top < -1)))
        found.push(`outside of the window: ${name(element)}`);
    }
    // A scrolling part of the panel scrolls up and down alone.
    for (const part of document.querySelectorAll(".panel-sections, .popover, .dialog-body"))
      if (part.scrollWidth > part.clientWidth) found.push(`scrolls sideways: ${name(part)}`);
    return found;
  });

/** In both themes and both sizes; colours do not change where things are, so that a large window need not be seen in both. */
async function everywhere(name: string, inLarge: readonly (typeof THEMES)[number][] = THEMES): Promise<void> {
  for (const size of SIZES) {
    const themes = size === SIZES[0] ? THEMES : inLarge;
    if (themes.length > 0) await editor.page.setViewportSize(size);
    for (const colorScheme of themes) {
      await editor.page.emulateMedia({ colorScheme });
      await until(() => editor.page.evaluate(() => document.documentElement.dataset.theme)).toBe(colorScheme);
      expect(await outside(), `${name} at ${size.width} in ${colorScheme}`).toEqual([]);
      await picture(editor.page, `looks-${name}-${size.width}-${colorScheme}`);
    }
  }
  await editor.page.setViewportSize(SIZES[0]);
}

it("fits an empty window", async () => {
  await editor.reload("check");
  await until(() => editor.page.locator(".start-cards svg").count()).toBe(3);
  await everywhere("start");
});

it("fits the bunny with all that Check says of it", async () => {
  await editor.take("bunny", "check");
  await editor.section("check").getByRole("button", { name: "Fix…" }).first().click();
  await editor.button("Apply").first().click();
  await editor.section("check").getByText("One wire runs through every edge").waitFor();
  await editor.section("check").getByRole("button", { name: "Fix…" }).first().click();
  await everywhere("bunny");
});

it("fits every section, opened to its last fold", async () => {
  await editor.take("house");
  for (const id of SECTIONS) {
    await editor.section(id).locator(".section-head").click();
    if (id === "animate") await editor.section(id).getByRole("listbox", { name: "Steps" }).waitFor();
    if (id === "frame") {
      await editor.section(id).getByText("Free", { exact: true }).click();
      await editor.section(id).getByRole("button", { name: "Compute", exact: true }).click();
      await editor.section(id).getByRole("table", { name: "Results" }).waitFor();
      await editor.section(id).getByText("Bend the wires with errors, and close their joints").click();
    }
    if (id === "export") await editor.section(id).locator(".preview pre").first().waitFor();
    if (id === "run") {
      await until(() =>
        editor.section("run").getByRole("button", { name: "Connect", exact: true }).getAttribute("aria-disabled"),
      ).toBeNull();
      await editor.section("run").getByRole("button", { name: "Connect", exact: true }).click();
      await until(() => editor.button("Home").getAttribute("aria-disabled")).toBeNull();
      await editor.button("Record").click();
    }
    for (let closed = 0; closed < 8; closed += 1) {
      const folds = editor.section(id).locator('.fold-head[aria-expanded="false"]');
      if ((await folds.count()) === 0) break;
      await folds.first().click();
    }
    await everywhere(id, LARGE.has(id) ? ["dark"] : []);
    await editor.section(id).locator(".section-head").click();
  }
});

/** From the smallest window that is supported to a large screen. */
const WINDOWS = [
  { width: 960, height: 600 },
  { width: 1280, height: 720 },
  { width: 1920, height: 1080 },
  { width: 2560, height: 1440 },
] as const;

/** Whether a click in the middle of STOP would press it. */
const stopIsThere = () =>
  editor.page.evaluate(() =>
    [...document.querySelectorAll(".stop-button")].some((button) => {
      const { left, right, top, bottom } = button.getBoundingClientRect();
      const inside = left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight && right - left > 40;
      const hit = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
      return inside && hit !== null && button.contains(hit);
    }),
  );

it("has STOP in sight in every window and theme, with every section, dialog, menu and message", async () => {
  await editor.take("house", ...SECTIONS);
  // As wide as it was made on a large screen.
  const edge = editor.page.getByRole("separator", { name: "Width of the panel" });
  await editor.page.setViewportSize(WINDOWS[3]);
  await edge.focus();
  await editor.page.keyboard.press("Home");
  // The test before may have left it connected.
  const { state } = await editor.loopback.ask("machine-state", {});
  if (state === null || state.phase === "closed") {
    const connect = editor.section("run").getByRole("button", { name: "Connect", exact: true });
    await until(() => connect.getAttribute("aria-disabled")).toBeNull();
    await connect.click();
  }
  await editor.section("run").locator(".run-phase.connected").waitFor();
  for (const size of WINDOWS) {
    await editor.page.setViewportSize(size);
    for (const colorScheme of THEMES) {
      await editor.page.emulateMedia({ colorScheme });
      await until(() => editor.page.evaluate(() => document.documentElement.dataset.theme)).toBe(colorScheme);
      const where = `at ${size.width} × ${size.height} in ${colorScheme}`;
      // Labels in the view follow in its next frame.
      await until(async () => [where, ...(await outside())]).toEqual([where]);
      expect(await stopIsThere(), `STOP ${where}`).toBe(true);
      if (colorScheme === "dark" || size.width <= 1280)
        await picture(editor.page, `looks-stop-${size.width}-${colorScheme}`);
    }
    await editor.drop("nothing.xyzzy", "x");
    await editor.messages.first().waitFor();
    expect(await stopIsThere(), `STOP beside a message at ${size.width}`).toBe(true);
    await editor.messages.first().getByRole("button", { name: "Dismiss" }).click();
    await editor.page.locator(".viewport canvas").focus();
    await editor.page.keyboard.press("?");
    await editor.page.getByRole("dialog", { name: "Keys" }).waitFor();
    expect(await stopIsThere(), `STOP beside a dialog at ${size.width}`).toBe(true);
    await editor.page.keyboard.press("Escape");
    await editor.page.getByRole("dialog", { name: "Keys" }).waitFor({ state: "detached" });
    await editor.page.locator(".viewport canvas").focus();
    await editor.page.keyboard.press("Shift+F10");
    await editor.page.getByRole("menu").waitFor();
    expect(await stopIsThere(), `STOP beside a menu at ${size.width}`).toBe(true);
    await editor.page.keyboard.press("Escape");
  }
  await editor.page.emulateMedia({ colorScheme: "dark" });
  await editor.button("Disconnect").click();
  await edge.dblclick();
  await editor.page.setViewportSize(SIZES[0]);
});

it("fits a narrow panel and a wide one, and shows lengths in inches", async () => {
  await editor.take("bunny", "edit", "check", "animate");
  const edge = editor.page.getByRole("separator", { name: "Width of the panel" });
  await edge.focus();
  await editor.page.keyboard.press("End");
  await editor.button("mm, the unit of lengths: change it").click();
  await editor.page.getByRole("table", { name: "Vertices" }).getByRole("columnheader", { name: "X, in" }).waitFor();
  expect(await outside()).toEqual([]);
  await picture(editor.page, "looks-narrow");
  await edge.focus();
  await editor.page.keyboard.press("Home");
  expect(await outside()).toEqual([]);
  await picture(editor.page, "looks-wide");
  await editor.isClean("looks");
});

it("stays where a person has scrolled the panel to", async () => {
  await editor.take("cube", "check", "edit", "run");
  await editor.page.setViewportSize({ width: 1280, height: 600 });
  const panel = editor.page.locator(".panel-sections");
  const scroll = () => panel.evaluate((box) => [Math.round(box.scrollTop), box.scrollHeight - box.clientHeight]);
  await editor.section("check").locator(".section-head").hover();
  const [at, end] = [async () => (await scroll())[0], async () => (await scroll())[1]];
  // What the sections say may still come, and make the panel longer.
  await until(async () => {
    await editor.page.mouse.wheel(0, 5000);
    return (await at()) === (await end());
  }).toBe(true);
  const down = await at();
  for (const y of [300, 320, 400]) await editor.page.mouse.move(1150, y);
  // What is drawn anew is reported in the next frames.
  await editor.page.keyboard.press("Control+a");
  await atRest(editor.page);
  expect(await at()).toBeGreaterThanOrEqual(down ?? 0);
  await editor.page.setViewportSize(SIZES[0]);
});

it("keeps what is under the pointer in the panel where it is when something above it grows", async () => {
  await editor.take("cube", "check", "edit", "run");
  await editor.page.setViewportSize({ width: 1280, height: 600 });
  const held = editor.section("run").locator(".section-body button").last();
  await held.scrollIntoViewIfNeeded();
  await held.hover();
  const top = () => held.evaluate((button) => Math.round(button.getBoundingClientRect().top));
  const height = () => editor.section("check").evaluate((section) => section.getBoundingClientRect().height);
  const [before, check] = [await top(), await height()];
  // What the checks say of the design is listed in the section above.
  await editor.page.keyboard.press("Control+a");
  await editor.page.keyboard.press("Delete");
  await until(height).not.toBe(check);
  await until(top).toBe(before);
  await editor.page.keyboard.press("Control+z");
  await until(height).toBe(check);
  // Also for a click that comes before the growth is drawn.
  const moved = await held.evaluate(async (button) => {
    const place = () => Math.round(button.getBoundingClientRect().top);
    const [was, line] = [place(), document.createElement("div")];
    line.style.height = "80px";
    button.closest(".section")?.prepend(line);
    await Promise.resolve();
    const by = place() - was;
    line.remove();
    return by;
  });
  expect(moved).toBe(0);
  await editor.page.setViewportSize(SIZES[0]);
});
