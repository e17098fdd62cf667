import { readFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { DesignView, Fix } from "../../../../ui/src/generated/responses.ts";
import { Editor, until } from "../../support/editor.ts";
import { type Place, Sight } from "../../support/sight.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const check = () => editor.section("check");

/** The lengths of these edges together, mm. */
function lengthOf(design: DesignView, wanted: readonly number[]): number {
  const at = new Map(design.vertices.map(({ id, at_mm }) => [id, at_mm]));
  let all = 0;
  for (const { id, a, b } of design.edges) {
    const [from, to] = [at.get(a), at.get(b)];
    if (from && to && wanted.includes(id)) all += Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  }
  return all;
}

async function cornerOf(place: Place): Promise<number | undefined> {
  const near = ({ at_mm }: DesignView["vertices"][number]) =>
    at_mm.every((value, k) => Math.abs(value - (place[k] ?? 0)) < 1e-6);
  return (await editor.design()).vertices.find(near)?.id;
}

/** Opens the fixes of a line of the list. */
async function fixesOf(title: string | RegExp): Promise<void> {
  await check().locator(".line", { hasText: title }).getByRole("button", { name: "Fix…" }).click();
}

it("fixes 22 odd corners with the edges that add least, shows it before, and takes it back", async () => {
  await editor.take("bunny", "check");
  await check().getByText("Needs more than one wire (22 odd corners)").waitFor();
  const { fixes } = await editor.loopback.ask("fixes", {});
  const doubles = fixes.find(({ edit }) => edit.edit === "doublings") as Fix & { edit: { edges: number[] } };
  const design = await editor.design();
  const added = lengthOf(design, doubles.edit.edges);
  // Figures of the example's published description.
  expect([doubles.edit.edges.length, added.toFixed(1)]).toEqual([11, "601.4"]);

  await fixesOf("22 odd corners");
  const fix = check().locator(".fix", { hasText: "Run the wire along 11 edges twice (+601.4 mm" });
  await fix.getByRole("button", { name: "Preview" }).click();
  const figures = editor.page.getByRole("region", { name: "Before and after the fix" });
  await figures.locator("tr", { hasText: "Wire" }).getByText("11\u202f821.4 mm").waitFor();
  expect(await fix.getByRole("button", { name: "Preview" }).getAttribute("aria-pressed")).toBe("true");
  await editor.isClean("check-preview");

  await fix.getByRole("button", { name: "Apply" }).click();
  await check().getByText("One wire runs through every edge").waitFor();
  expect((await editor.design()).state.doublings.toSorted()).toEqual(doubles.edit.edges.toSorted());
  const all =
    lengthOf(
      design,
      design.edges.map(({ id }) => id),
    ) + added;
  const shown = () =>
    editor.page.getByRole("contentinfo").locator("div", { hasText: /^Wire/ }).locator("dd").innerText();
  await until(async () => Number((await shown()).replaceAll(/[^\d.]/g, ""))).toBeCloseTo(all, 1);
  expect(await shown()).toMatch(/ mm$/);

  await editor.button(/^Undo/).click();
  await check().getByText("Needs more than one wire (22 odd corners)").waitFor();
  expect((await editor.design()).state.doublings).toEqual([]);
});

it("bends a design from several wires, each with its figures beforehand, and closes it again", async () => {
  await editor.take("bunny", "check", "edit");
  await fixesOf("22 odd corners");
  const titles = await check().locator(".fix-title").allInnerTexts();
  expect(titles.map((title) => title.replace(/ edges?.*/, ""))).toEqual([
    "Run the wire along 11",
    "Split into 2 wires, run along 9",
    "Split into 3 wires, run along 8",
    "Split into 4 wires, run along 7",
    "Split into 5 wires, run along 6",
    "Split into 6 wires, run along 5",
  ]);
  const fix = check().locator(".fix", { hasText: "Split into 3 wires" });
  const figures = await fix.locator(".muted").innerText();
  expect(figures).toMatch(/^11\u202f[\d.]+ mm · stock [\d.]+ m · \d+:\d+ · \$[\d.]+ · gives 3 wires/);
  await fix.getByRole("button", { name: "Apply" }).click();
  await check().getByText("3 wires run through every edge").waitFor();

  const most = editor.section("edit").getByLabel("Most wires");
  await until(() => most.inputValue()).toBe("3");
  const starts = async () => (await editor.loopback.ask("check", {})).wires.map(({ route }) => route[0]);
  const before = await starts();
  await editor.section("edit").getByLabel("Reversed: the wire runs the other way").click();
  await until(async () => (await starts()).some((start, k) => start !== before[k])).toBe(true);
  await editor.section("edit").getByLabel("Closed: the wire ends where it starts").click();
  await until(() => most.inputValue()).toBe("1");
  await check().getByText("Cannot be a closed wire (6 odd corners)").waitFor();
});

it("says an edge is too short as soon as it is, and moves a vertex to fix it", async () => {
  await editor.take("house", "check", "edit");
  await check().getByText("Edges long enough").waitFor();
  const corner = await cornerOf([35, 0, 0]);
  const field = editor.page.getByRole("table", { name: "Vertices" }).getByLabel(`Vertex ${corner}, Z, mm`);
  await field.fill("45");
  await field.press("Enter");
  // Of 60 mm of wall 15 are left.
  await until(() => editor.phrase("check")).toMatch(/^Error: \d+ to fix$/);
  const line = check()
    .locator(".line", { hasText: /too short/ })
    .first();
  expect(await line.locator(".line-sub").innerText()).toMatch(/15\.0 mm, limit \d+\.\d mm/);
  await line.getByRole("button", { name: "Fix…" }).waitFor();
  await editor.isCleanNow("check-short");

  const annotation = editor.page.locator(".viewport div", { hasText: /^\S*\s*15\.0 mm/ });
  await annotation.first().waitFor();
  await check().getByLabel("Annotations in the view").uncheck();
  await until(() => annotation.count()).toBe(0);
  await check().getByLabel("Annotations in the view").check();
  await annotation.first().waitFor();

  await line.getByRole("button", { name: "Fix…" }).click();
  const fix = check()
    .locator(".fix", { hasText: /Move vertex/ })
    .first();
  await fix.getByRole("button", { name: "Preview" }).click();
  const figures = editor.page.getByRole("region", { name: "Before and after the fix" });
  const [now, then] = await figures.locator("tr", { hasText: "Errors" }).locator("td").allInnerTexts();
  expect(Number(then)).toBeLessThan(Number(now));
  await fix.getByRole("button", { name: "Apply" }).click();
  await check().getByText("Edges long enough").waitFor();
  expect(await editor.phrase("check")).toMatch(/within limits|to look at/);
});

it("words lengths in the unit that is shown, and in millimetres what it keeps", async () => {
  await editor.take("house", "check", "edit");
  const corner = await cornerOf([35, 0, 0]);
  const field = editor.page.getByRole("table", { name: "Vertices" }).getByLabel(`Vertex ${corner}, Z, mm`);
  await field.fill("45");
  await field.press("Enter");
  const title = check()
    .locator(".fix-title", { hasText: /^Move vertex/ })
    .first();
  const open = () =>
    check()
      .locator(".line", { hasText: /too short/ })
      .getByRole("button", { name: "Fix…" })
      .first()
      .click();
  await open();
  expect(await title.innerText()).toMatch(/ by \d+\.\d mm$/);
  const path = join(editor.loopback.home, "files", "house.wbjob");
  const sheet = join(editor.loopback.home, "files", "house.pdf");
  const said = async () =>
    (await editor.loopback.ask("check", { moved: [] })).diagnostics.map(({ message }) => message);
  // The objections of a job, and what a job sheet lists, have lengths in them.
  const kept = async () => {
    const { job_hash } = await editor.loopback.ask("save-job", { output: { path, force: true }, despite_errors: true });
    const settings = { date: "2026-01-31" };
    const output = { path: sheet, force: true };
    await editor.loopback.ask("export", { format: "job-sheet", settings, output, despite_errors: true });
    return [job_hash, readFileSync(sheet).toString("base64")];
  };
  const before = await kept();
  expect((await said()).join()).toMatch(/ mm\b/);

  await editor.button("mm, the unit of lengths: change it").click();
  await until(async () => {
    if ((await title.count()) === 0) await open();
    return title.innerText();
  }).toMatch(/ by \d+\.\d{3} in$/);
  expect((await said()).join()).toMatch(/ in\b/);
  expect((await said()).join()).not.toMatch(/ mm\b/);
  expect(await kept()).toEqual(before);
  expect(JSON.parse(readFileSync(path, "utf8")).objections.join()).toMatch(/ mm\b/);
  await editor.button("in, the unit of lengths: change it").click();
});

it("answers while a vertex is dragged, before it is let go", async () => {
  await editor.take("house", "check");
  await check().getByText("Edges long enough").waitFor();
  const before = await editor.design();
  const sight = await Sight.from(
    editor.page,
    "front",
    before.vertices.map(({ at_mm }) => at_mm),
  );
  const { mouse } = editor.page;
  const [from, to] = [sight.at([35, 0, 0]), sight.at([35, 0, 45])];
  await mouse.move(from.x, from.y);
  await editor.page.locator(".hover-card", { hasText: /^Vertex/ }).waitFor();
  await mouse.down();
  await mouse.move(to.x, to.y, { steps: 8 });
  await until(() => editor.phrase("check")).toMatch(/to fix/);
  expect((await editor.design()).vertices).toEqual(before.vertices);
  await mouse.move(from.x, from.y - 5 / sight.pixel, { steps: 8 });
  await until(() => editor.phrase("check")).toMatch(/within limits|to look at/);
  await mouse.move(to.x, to.y, { steps: 4 });
  await mouse.up();
  await until(() => editor.phrase("check")).toMatch(/to fix/);
  await until(async () => (await editor.design()).state.undo).not.toBeNull();
  expect((await editor.design()).vertices).not.toEqual(before.vertices);
});

it("frames and selects what a line is about, and lists the places of several", async () => {
  await editor.take("bunny", "check", "edit");
  await check().getByText("Needs more than one wire (22 odd corners)").click();
  await editor
    .section("edit")
    .getByText(/^22 vertices/)
    .waitFor();
  await editor.isClean("check");
});

it("predicts how far off the machine will make it, what that comes from and how exact it has to be", async () => {
  await editor.take("house", "check", "edit");
  const accuracy = check().locator(".part", { hasText: "Accuracy" });
  await accuracy.getByLabel("Errors of").selectOption("bend-forming");
  await accuracy.getByLabel("Within").fill("2");
  await accuracy.getByRole("button", { name: "Predict", exact: true }).click();
  const expected = accuracy.getByRole("table", { name: "Expected accuracy" });
  await expected.waitFor();
  const rows = await expected.locator("tbody tr").allInnerTexts();
  expect(rows).toHaveLength(2);
  for (const row of rows) expect(row).toMatch(/vertex \d[\s\S]* mm[\s\S]* mm/);
  // The largest is named first.
  const shares = await accuracy
    .getByRole("table", { name: "What the errors come from" })
    .locator("tbody td:nth-child(2)");
  const rms = (await shares.allInnerTexts()).map(Number.parseFloat);
  // The house is flat: no rotation could be off.
  expect(rms).toHaveLength(3);
  expect(rms).toEqual(rms.toSorted((a, b) => b - a));
  const needed = accuracy.getByRole("table", { name: "Tolerance" });
  expect(await needed.innerText()).toMatch(/To be within 2 mm[\s\S]*Feeds\s+± [\d.]+ mm[\s\S]*Rotations\s+any/);
  await accuracy.getByRole("button", { name: /^Vertex by vertex/ }).click();
  const each = await accuracy.getByRole("table", { name: "Accuracy of each vertex" }).getByRole("row").allInnerTexts();
  expect(each).toHaveLength((await editor.design()).vertices.length + 1);
  const within = each.slice(1).map((row) => Number.parseFloat(row.split(/\s*\n\s*/)[2] ?? ""));
  expect(within).toEqual(within.toSorted((a, b) => b - a));
  // The wire begins and ends at one corner of the house.
  expect(each.filter((row) => !row.endsWith("–"))).toHaveLength(2);
  await accuracy.getByRole("checkbox", { name: "Show in the view" }).scrollIntoViewIfNeeded();
  await editor.isClean("check-accuracy");
  // It is of the design as it is, also where that was another one for a moment.
  const since = accuracy.getByText("Changed since it was predicted.");
  await editor
    .section("edit")
    .getByLabel(/^Reversed/)
    .click();
  await since.waitFor();
  await editor.page.keyboard.press("Control+z");
  await since.waitFor({ state: "detached" });
  // It is of the design as it was: a change takes it out of the view, and it is said.
  await expected
    .getByRole("button", { name: /^vertex/ })
    .first()
    .click();
  await editor.page.keyboard.press("Control+z");
  await accuracy.getByLabel("Within").fill("1");
  await accuracy.getByLabel("Within").press("Enter");
  await accuracy.getByText("Changed since it was predicted.").waitFor();
  expect(await accuracy.getByRole("checkbox", { name: "Show in the view" }).isChecked()).toBe(false);
});
