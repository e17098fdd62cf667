import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";
import { Sight } from "../../support/sight.ts";

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

/** Turns to the front of the house. */
const front = () => Sight.front(editor);

it("shows its own menu on a right click, with what can be done there", async () => {
  await editor.take("house", "edit");
  const sight = await front();
  const { x, y } = sight.at([35, 0, 30]);
  await editor.page.mouse.click(x, y, { button: "right" });
  await until(selected).toMatch(/1 edge/);
  await menu()
    .getByRole("menuitem", { name: /^Split/ })
    .waitFor();
  await editor.isCleanNow("still-menu");
  await menu()
    .getByRole("menuitem", { name: /^Split/ })
    .click();
  await until(edges).toBe(7);
  await menu().waitFor({ state: "detached" });
  await press("Control+z");
  await until(edges).toBe(6);

  // Every entry can be clicked, whatever the menu is laid over.
  for (const [width, height] of [
    [960, 600],
    [1280, 650],
    [1280, 800],
  ] as const) {
    await editor.page.setViewportSize({ width, height });
    const view = await front();
    const edge = view.at([35, 0, 30]);
    for (const down of [0, 60]) {
      await editor.page.mouse.click(edge.x, edge.y + down, { button: "right" });
      await menu().getByRole("menuitem").first().waitFor();
      const covered = await menu()
        .getByRole("menuitem")
        .evaluateAll((entries) =>
          entries
            .filter((entry) => {
              const { left, top, width, height } = entry.getBoundingClientRect();
              const [x, y] = [left + width / 2, top + height / 2];
              // A menu that is higher than the window is scrolled.
              const end = entry.closest("[role=menu]")?.getBoundingClientRect().bottom ?? 0;
              return y < end - 6 && !entry.contains(document.elementFromPoint(x, y));
            })
            .map((entry) => entry.textContent),
        );
      expect(covered, `${width} × ${height}`).toEqual([]);
      const stop = editor.page.getByRole("button", { name: /^STOP/ });
      const seen = await stop.evaluate((button) => {
        const { left, top, width, height } = button.getBoundingClientRect();
        return button.contains(document.elementFromPoint(left + width / 2, top + height / 2));
      });
      expect(seen, "STOP").toBe(true);
      await press("Escape");
      await menu().waitFor({ state: "detached" });
    }
  }

  // Turning the view with the right button asks for nothing.
  await editor.page.mouse.move(x - 80, y);
  await editor.page.mouse.down({ button: "right" });
  await editor.page.mouse.move(x - 20, y, { steps: 5 });
  await editor.page.mouse.up({ button: "right" });
  expect(await menu().count()).toBe(0);

  // By the keyboard, and closed by it.
  await canvas().focus();
  await press("Shift+F10");
  await menu().getByRole("menuitem").first().waitFor();
  await press("Escape");
  await menu().waitFor({ state: "detached" });
  await until(() => editor.page.evaluate(() => document.activeElement?.tagName)).toBe("CANVAS");
});

it("offers in a field what a field can do, and gives it the focus back", async () => {
  const field = editor.page.getByRole("table", { name: "Vertices" }).getByLabel("Vertex 1, X, mm");
  await field.click();
  await field.fill("42");
  await field.click({ button: "right" });
  await menu().getByRole("menuitem", { name: "Select all" }).click();
  await until(() => field.evaluate((input) => document.activeElement === input)).toBe(true);
  // Nothing of what was typed is lost, nor taken before Enter.
  expect(await field.inputValue()).toBe("42");
  expect((await editor.vertex(1))[0]).toBe(35);
  await press("Escape");
  const heading = editor.section("edit").getByRole("heading", { name: "Vertices", exact: true });
  // A click elsewhere leaves the field, as it does without a menu.
  await field.fill("42");
  await field.click({ button: "right" });
  await menu().getByRole("menuitem", { name: "Select all" }).waitFor();
  await heading.click();
  await until(async () => (await editor.vertex(1))[0]).toBe(42);
  await press("Control+z");
  await until(async () => (await editor.vertex(1))[0]).toBe(35);
  await heading.click({ button: "right" });
  await menu().getByRole("menuitem", { name: "Keys" }).waitFor();
  await press("Escape");
});
