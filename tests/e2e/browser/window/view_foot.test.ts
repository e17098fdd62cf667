/** What is written over the foot of the view: help at the pointer, what is measured, the notes of a file. */
import { readFileSync } from "node:fs";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor } from "../../support/editor.ts";
import { root } from "../../support/places.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  await editor.take(null, "parts");
  await editor.drop("bracket.svg", readFileSync(`${root}examples/bracket.svg`));
  await editor.page.getByRole("dialog").getByRole("button", { name: "Open" }).click();
  await editor.page.locator(".open-notes").waitFor();
});
afterAll(() => editor?.end());

const TOOLS = ["s", "d", "t", "u"];

/** Which of the texts cover each other, are cut off, or leave the view. */
const wrong = () =>
  editor.page.evaluate(() => {
    const view = document.querySelector(".work")?.getBoundingClientRect() ?? new DOMRect();
    const found = [".pointer-hint > span", ".measuring", ".open-notes", ".open-notes-list"]
      .flatMap((of) => [...document.querySelectorAll<HTMLElement>(of)])
      .map((element) => ({ element, box: element.getBoundingClientRect(), text: element.textContent ?? "" }));
    const covers = (a: DOMRect, b: DOMRect) =>
      a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    return found.flatMap(({ element, box, text }, index) => [
      ...(element.scrollWidth > element.clientWidth && getComputedStyle(element).display !== "inline"
        ? [`${text} is cut off`]
        : []),
      ...(box.left < view.left || box.right > view.right || box.bottom > view.bottom
        ? [`${text} leaves the view`]
        : []),
      ...found.slice(index + 1).flatMap((other) => (covers(box, other.box) ? [`${text} covers ${other.text}`] : [])),
    ]);
  });

it.each([
  [1280, 800],
  [960, 600],
])("is whole at %i × %i with every tool, beside the notes and their list", async (width, height) => {
  await editor.page.setViewportSize({ width, height });
  const notes = editor.page.locator(".open-notes-head");
  for (const expanded of ["false", "true"]) {
    if ((await notes.getAttribute("aria-expanded")) !== expanded) await notes.click();
    for (const key of TOOLS) {
      await editor.page.locator(".viewport canvas").focus();
      await editor.page.keyboard.press(key);
      const clauses = await editor.page.locator(".pointer-hint > span").count();
      expect([clauses, await wrong()], `${key}, list ${expanded}`).toEqual([4, []]);
    }
  }
  await editor.isClean(`view-foot-${width}`);
  await notes.click();
});
