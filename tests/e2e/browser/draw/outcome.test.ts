import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";
import type { Place } from "../../support/sight.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const form = () => editor.section("edit").locator("#operation-fillet");
const shapes = () => editor.section("edit").getByRole("group", { name: "Shapes" });
const said = async () => (await form().getByRole("status").innerText()).replaceAll(/\s+/g, " ").trim();
const focusView = () => editor.page.locator(".viewport canvas").focus();

/** A strand that is bent by 90°, 60° and 120°. */
const STRAND: readonly Place[] = [
  [0, 0, 0],
  [300, 0, 0],
  [300, 0, 300],
  [300, 259.8, 450],
  [83.5, 151.5, 387.5],
];

/** What was made: how many chords, and the shortest. */
async function made(before: ReadonlySet<number>): Promise<{ chords: number; shortest: number }> {
  const { vertices, edges } = await editor.design();
  const at = new Map(vertices.map(({ id, at_mm }) => [id, at_mm]));
  const chords = edges
    .filter(({ id }) => !before.has(id))
    .map(({ a, b }) => Math.hypot(...[0, 1, 2].map((k) => (at.get(a)?.[k] ?? NaN) - (at.get(b)?.[k] ?? NaN))));
  return { chords: chords.length, shortest: Math.min(...chords) };
}

it.each(["wirebend-kit", "pensa-diwire-pro", "grbl-bender"])(
  "tells what a fillet makes on %s before it is made, while the radius is typed",
  async (machine) => {
    await editor.loopback.ask("new", {});
    await editor.loopback.ask("edit", { request: { edit: "draw", through_mm: STRAND.map((at) => [...at]) } });
    await editor.loopback.ask("edit", { request: { edit: "machine", machine } });
    await editor.reload("edit");
    await editor.section("edit").locator(".section-phrase", { hasText: "5 vert" }).waitFor();
    await focusView();
    for (const key of ["a", "b"]) await editor.page.keyboard.press(key);
    // The ends of the strand are no corners.
    const radius = form().getByLabel("Radius");
    const outcomes = new Set<string>();
    for (const mm of [8, 40, 60, 90, 250]) {
      await radius.fill(String(mm));
      await until(said).toMatch(/ mm/);
      const text = await said();
      const before = await editor.design();
      await radius.press("Enter");
      const foretold =
        /^Fine: (\d+) chords on 3 corners, the shortest (\d+\.\d) mm; the machine needs \d+\.\d mm\.(?: Check warns of a length near a limit\.)?$/.exec(
          text,
        );
      outcomes.add(foretold ? "made" : "refused");
      if (foretold) {
        await until(async () => (await editor.design()).edges.length).toBeGreaterThan(before.edges.length);
        const { chords, shortest } = await made(new Set(before.edges.map(({ id }) => id)));
        expect([text, chords, shortest.toFixed(1)]).toEqual([text, Number(foretold[1]), foretold[2]]);
        await focusView();
        await editor.page.keyboard.press("Control+z");
        await until(async () => (await editor.design()).edges.length).toBe(before.edges.length);
        await editor.page.keyboard.press("a");
      } else {
        const needed = /needs (\d+\.\d mm)/.exec(text)?.[1] ?? "";
        const fits = /^(The nearest radius that fits is|No fillet can be made here)/;
        await form().getByText(fits).first().waitFor();
        expect((await editor.design()).edges).toHaveLength(before.edges.length);
        // What makes it says the same.
        const made = editor.loopback.ask("edit", {
          request: { edit: "fillet", vertices: [1, 2, 3], radius_mm: mm, step_deg: 15 },
        });
        await expect(made).rejects.toThrow(`fillet of ${mm}`);
        await expect(made).rejects.toThrow(needed);
      }
    }
    expect([...outcomes].sort()).toEqual(["made", "refused"]);
    await radius.fill("8");
    await until(said).toMatch(/^Error: Two chords/);
    await editor.isClean(`outcome-fillet-${machine}`);
    // One that can be made at all three corners.
    await form().getByRole("button", { name: /^Use / }).click();
    await until(said).toMatch(/^Fine: /);
  },
);

it("tells when the edges of a shape are too short, and offers the number that fits", async () => {
  await editor.loopback.ask("new", {});
  await editor.loopback.ask("edit", { request: { edit: "machine", machine: "wirebend-kit" } });
  await editor.reload("edit");
  const status = async () => (await shapes().getByRole("status").innerText()).replaceAll(/\s+/g, " ").trim();
  // The first edge has to reach the peg: 12 + 20.4 - 3.175 - 1.5 = 27.7 mm of wire, 3·tan 15° of its edge longer, 2.4·π/6 shorter.
  await until(status).toMatch(/^Fine: Each edge 31\.1 mm; the machine needs 27\.3 mm\.$/);
  await shapes().getByLabel("Radius").fill("30");
  await until(status).toMatch(/^Error: Each edge 15\.5 mm; the machine needs 27\.3 mm\.$/);
  await editor.isClean("outcome-shape");
  await shapes().getByRole("button", { name: "Use 6 edges" }).click();
  await until(status).toMatch(/^Fine: Each edge 30\.0 mm/);
  await shapes().getByRole("button", { name: "Add circle" }).click();
  await until(async () => (await editor.design()).edges.length).toBe(6);
  const check = await editor.loopback.ask("check", { moved: [] });
  expect([check.feasible, check.diagnostics.filter(({ severity }) => severity === "error")]).toEqual([true, []]);
  await shapes().getByText("Polygon", { exact: true }).click();
  await shapes().getByLabel("Size is").selectOption("side");
  await shapes().getByRole("textbox", { name: "Size", exact: true }).fill("12");
  await until(status).toMatch(/^Error: Each edge 12\.0 mm; .*No number of edges fits\.$/);
});
