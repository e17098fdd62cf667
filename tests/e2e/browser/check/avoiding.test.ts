import { readFileSync } from "node:fs";
import type { Locator } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;

beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const animate = () => editor.section("animate");
const button = (name: string) => animate().getByRole("button", { name, exact: true });
const search = () => button("Avoid collisions").or(button("Search again"));
const fix = (title: string) => animate().locator(".fix", { hasText: title });

const placeOf = async (one: Locator) => (await one.boundingBox()) ?? { x: 0, y: 0 };

/** A number in the settings of the search. */
async function set(label: string, value: string): Promise<void> {
  const field = animate().getByLabel(label, { exact: true });
  await field.fill(value);
  await field.press("Enter");
}

it("says what is wrong with a setting at its field, and has the usual ones", async () => {
  await editor.take("cup-holder", "edit", "animate");
  await button("Avoid collisions").waitFor();
  await animate()
    .getByRole("button", { name: /^Search settings/ })
    .click();
  const effort = animate().getByLabel("Effort", { exact: true });
  expect((await effort.inputValue()).replace(/\s/g, "")).toBe("20000");
  await effort.fill("0");
  await animate()
    .getByText(/^Expected from 1 to/)
    .waitFor();
  await effort.press("Escape");
  await animate().getByText("Weighed", { exact: true }).click();
  for (const [label, usual] of [
    ["A wire", "1000"],
    ["A doubled mm", "1"],
    ["A second", "5"],
  ] as const) {
    expect((await animate().getByLabel(label, { exact: true }).inputValue()).replace(/\s/g, "")).toBe(usual);
    await set(label, "0");
  }
  await animate().getByText("One of the weights has to be more than 0").waitFor();
  await editor.isClean("avoid-settings");
  await animate().getByText("In order", { exact: true }).click();
});

it("says what was in the way of a search, leads there, and makes what was tried and helps", async () => {
  await set("Most wires", "1");
  await search().click();
  const way = button("At vertex 1 the wire would hit the nozzle");
  await way.waitFor();
  await animate().getByText("The search got as far as edge 11 of 11. Every walk of one wire was tried.").waitFor();
  await animate().getByText("Nothing was found with an edge run along twice.").waitFor();
  await fix("Bend 2 wires that hit nothing").getByText("Cut at vertices: from 0 to 1, from 10 to 1").waitFor();
  await editor.isClean("avoid-failed");
  await way.click();
  await editor.section("edit").getByLabel("Vertex 1, X, mm").first().waitFor();
  await editor.isClean("avoid-failed-vertex");
  await fix("Move vertex 1 by 1.0 mm").getByRole("button", { name: "Apply" }).click();
  await animate().getByText("No collision found.").waitFor();
  // What it has found is not lost without a word.
  const walks = async () => (await editor.design()).state.walks;
  const found = JSON.stringify(await walks());
  await editor
    .section("edit")
    .getByLabel(/^Reversed/)
    .click();
  const lost = editor.messages.filter({ hasText: "The chosen order of the bends is given up" });
  await lost.waitFor();
  // The panel is scrolled below.
  await editor.page.mouse.move(400, 300);
  expect(await walks()).toEqual([]);
  await editor.page.keyboard.press("Control+z");
  await animate().getByText("No collision found.").waitFor();
  await lost.waitFor({ state: "detached" });
  expect(JSON.stringify(await walks())).toBe(found);
  // Also what is between two things of a section stays under the pointer when the list above them comes back.
  const expected = animate().locator(".expected");
  const accuracy = expected.locator("..");
  const contacts = animate()
    .locator(".stack", { has: editor.page.getByLabel("Stop at collisions") })
    .last();
  for (const [above, below] of [
    [expected, expected],
    // From between two things to between two others of the same section, without anything in between.
    [contacts, accuracy],
  ] as const) {
    // What is above the panel's upper edge has no pointer on it.
    await below.evaluate((element) => element.scrollIntoView({ block: "center" }));
    const [from, { x, y }] = [await placeOf(above), await placeOf(below)];
    await editor.page.mouse.move(from.x + 40, from.y - 3);
    await editor.page.mouse.move(x + 40, y - 3);
    await editor.page.keyboard.press("Control+z");
    await until(() => search().count()).toBe(1);
    expect((await below.boundingBox())?.y).toBeCloseTo(y, 0);
    await editor.page.keyboard.press("Control+Shift+z");
    await animate().getByText("No collision found.").waitFor();
  }
  await editor.page.keyboard.press("Control+z");
  await until(() => search().count()).toBe(1);
});

/** Opens an OBJ of these lines. */
async function open(...lines: string[]): Promise<void> {
  const bytes = [...Buffer.from(lines.join("\n"))];
  await editor.loopback.ask("open", { design: { input: { bytes: { name: "drawn.obj", bytes } }, units: "mm" } });
  await editor.reload("animate");
}

it("plays nothing of a design that no wire can follow, and says so", async () => {
  await open("v 0 0 0", "v 100 0 0", "v 0 100 0", "v 0 0 100", "l 1 2", "l 1 3", "l 1 4");
  const play = editor.page.getByLabel("Timeline").getByRole("button", { name: "Play" });
  await until(() => play.getAttribute("title")).toBe("There is no program: see Check.");
  expect(await play.getAttribute("aria-disabled")).toBe("true");
});

it("says that it was not searched where a bend comes first that no order avoids, and offers no search that says the same", async () => {
  // The second corner is bent by 174°.
  await open("v 0 0 0", "v 120 0 0", "v 10 12 0", "v 10 60 0", "v 70 60 0", "v 70 20 10", "l 1 2 3 4 5 6");
  await search().click();
  await animate().getByText("It was not searched: a bend that no order avoids comes first.").waitFor();
  expect(await button("Search again").getAttribute("aria-disabled")).toBe("true");
  await button("The bend at vertex 1").click();
  await editor.isClean("avoid-unsearched");
  // Other wires may have no such bend.
  await animate()
    .getByRole("button", { name: /^Search settings/ })
    .click();
  await set("Most wires", "2");
  await until(() => button("Search again").getAttribute("aria-disabled")).toBeNull();
});

it("says how far it is, and ends with the best until then", async () => {
  const bytes = [...readFileSync(new URL("../../../../examples/cube.obj", import.meta.url))];
  await editor.loopback.ask("open", { design: { input: { bytes: { name: "cube.obj", bytes } }, units: "mm" } });
  const { fixes } = await editor.loopback.ask("fixes", {});
  const twice = fixes.find(({ title }) => title.includes("twice"));
  if (!twice) throw new Error("a cube is no single wire without edges that are run along twice");
  await editor.loopback.ask("edit", { request: twice.edit });
  await editor.reload("animate");
  await search().waitFor();
  await animate()
    .getByRole("button", { name: /^Search settings/ })
    .click();
  await set("Effort", "4000000000");
  await set("Most wires", "1");
  await search().click();
  await animate()
    .getByText(/^[1-9].* of at most 4\D*000\D*000\D*000 steps checked$/)
    .waitFor();
  await animate().getByText("No program without a collision found so far.").waitFor();
  await editor.isClean("avoid-underway");
  await button("Stop").click();
  await animate()
    .getByText(/steps were checked until it was ended. No change that could help was tried/)
    .waitFor();
  await editor.isClean("avoid-ended");
});
