import { existsSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const press = (key: string) => editor.page.keyboard.press(key);

/** What has the focus: its name, and whether a person sees that it has it. */
const focused = () =>
  editor.page.evaluate(() => {
    const element = document.activeElement;
    if (!(element instanceof HTMLElement) || element === document.body) return null;
    const shows = (one: Element) => {
      const { outlineStyle, outlineWidth, boxShadow } = getComputedStyle(one);
      return (outlineStyle !== "none" && Number.parseFloat(outlineWidth) > 0) || boxShadow !== "none";
    };
    // A field shows it at its frame, a hidden radio button at its label, the edge of the panel by its line.
    const near = [
      element,
      element.parentElement,
      element.parentElement?.parentElement,
      element.nextElementSibling,
    ].filter((one) => one instanceof Element);
    const line = getComputedStyle(element).backgroundImage !== "none";
    const text = element.getAttribute("aria-label") ?? element.textContent ?? "";
    return {
      name: text.replaceAll(/\s+/g, " ").trim(),
      visible: element.matches(":focus-visible") && (line || near.some(shows)),
      tag: element.tagName,
    };
  });

/** Presses Tab until something of this name has the focus; everything on the way shows that it has it. */
async function tabTo(name: string | RegExp, key: "Tab" | "Shift+Tab" = "Tab"): Promise<void> {
  const seen: string[] = [];
  for (let presses = 0; presses < 120; presses += 1) {
    await press(key);
    const now = await focused();
    if (!now) continue;
    seen.push(now.name.slice(0, 40));
    expect(now.visible, `focus on ${now.tag} “${now.name.slice(0, 60)}”`).toBe(true);
    if (typeof name === "string" ? now.name === name : name.test(now.name)) return;
  }
  throw new Error(`Tab does not lead to ${String(name)}; it leads to ${seen.join(" | ")}`);
}

it("opens an example through the menus", async () => {
  await tabTo("File");
  await press("ArrowDown");
  for (let presses = 0; (await focused())?.name !== "Examples…"; presses += 1) {
    expect(presses).toBeLessThan(12);
    await press("ArrowDown");
  }
  await press("Enter");
  await editor.page.getByRole("dialog", { name: "Examples" }).waitFor();
  await tabTo(/^BunnyNeeds more/);
  await press("Enter");
  await until(() => editor.page.locator(".top-name").innerText()).toBe("Bunny");
});

it("fixes what Check names", async () => {
  await editor.section("check").getByRole("button", { name: "Fix…" }).first().waitFor();
  await tabTo("Fix…");
  await press("Enter");
  await tabTo("Preview");
  await press("Space");
  expect(await editor.button("Preview").first().getAttribute("aria-pressed")).toBe("true");
  await tabTo("Apply");
  await press("Enter");
  await editor.section("check").getByText("One wire runs through every edge").waitFor();
  await press("Control+z");
  await editor.section("check").getByText("22 odd corners").waitFor();
  await press("Control+y");
  await editor.section("check").getByText("One wire runs through every edge").waitFor();
});

it("plays with Space, and goes through the steps with the arrows", async () => {
  await tabTo(/^Animate/);
  await press("Enter");
  await editor.section("animate").getByRole("listbox", { name: "Steps" }).waitFor();
  await tabTo("View of the design. Keys: question mark lists them.", "Shift+Tab");
  await press("Space");
  await editor.page.locator(".timeline").getByRole("button", { name: "Pause" }).waitFor();
  await press("Space");
  await editor.page.locator(".timeline").getByRole("button", { name: "Play" }).waitFor();
  const step = editor.page.locator(".timeline-step");
  // Not one of the collisions, which are listed as soon as they are known: "Step 14 hits the head".
  await tabTo(/^(Steps|Step 1(?!\d|:| hits))/);
  await press("End");
  await until(() => step.innerText()).toMatch(/step 176 \/ 176/);
  await press("Home");
  await until(() => step.innerText()).toMatch(/step 1 \/ 176/);
  await press("ArrowDown");
  await until(() => step.innerText()).toMatch(/step 2 \/ 176/);
});

it("writes a file", async () => {
  await tabTo(/^Export/);
  await press("Enter");
  await editor.section("export").getByLabel("Format").waitFor();
  await tabTo(/WireBend-kit text.*/);
  await press("l");
  await tabTo(/^Write it anyway|^on$|^$/);
  await press("Space");
  await tabTo("Write…");
  await until(() => editor.button("Write…").getAttribute("aria-disabled")).toBeNull();
  await press("Enter");
  await editor.section("export").locator(".written").waitFor();
  const file = await editor.section("export").locator(".written .selectable").innerText();
  expect(file.startsWith(join(editor.loopback.home, "files"))).toBe(true);
  expect(existsSync(file)).toBe(true);
});

it("connects, and stops with Ctrl-Space also out of a list of choices", async () => {
  await tabTo(/^Run/);
  await press("Enter");
  await editor.button("Connect").waitFor();
  await until(() => editor.button("Connect").getAttribute("aria-disabled")).toBeNull();
  await tabTo("Connect");
  await press("Enter");
  const phase = editor.section("run").locator(".run-phase");
  await phase.and(editor.page.locator(".connected")).waitFor();
  await until(() => editor.button("Home").getAttribute("aria-disabled")).toBeNull();
  await tabTo("Home");
  await press("Enter");
  await phase.and(editor.page.locator(".homing")).waitFor();
  await press("Control+Space");
  // The machine first, then the window.
  await until(async () => (await editor.loopback.ask("machine-state", {})).state?.phase).toBe("stopped");
  await phase.and(editor.page.locator(".stopped")).waitFor();
});

it("lists the keys, with a question mark, and stops from there too", async () => {
  await editor.page.locator(".viewport canvas").focus();
  await press("?");
  const keys = editor.page.getByRole("dialog", { name: "Keys" });
  await keys.getByText("STOP the machine").waitFor();
  await editor.isCleanNow("keyboard-keys");
  // Behind a dialog nothing else has a key.
  await press("x");
  await press("Escape");
  await keys.waitFor({ state: "detached" });
  expect((await editor.design()).vertices).toHaveLength(57);
});

it("turns to the sides, and to the same view without perspective and back", async () => {
  await editor.page.locator(".viewport canvas").focus();
  const shown = () =>
    editor.page.getByRole("group", { name: "View" }).getByRole("button", { pressed: true }).innerText();
  for (const [key, name] of [
    ["1", "Front"],
    ["3", "Right"],
    ["7", "Top"],
    ["5", "Perspective"],
    ["5", "Parallel"],
    ["5", "Perspective"],
  ] as const) {
    await press(key);
    await until(async () => (await shown()).replaceAll(/\s/g, "")).toBe(
      `${name === "Parallel" ? "5" : { Front: "1", Right: "3", Top: "7", Perspective: "5" }[name]}${name}`,
    );
  }
  await editor.isClean("keyboard");
});
