import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";
import { Sight } from "../../support/sight.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const parts = () => editor.section("parts");
const stencils = async () => (await editor.design()).state.stencils;

/** A pyramid on a square of 60 mm. */
const PYRAMID = "v 0 0 0\nv 60 0 0\nv 60 60 0\nv 0 60 0\nv 30 30 40\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

async function fill(label: string, text: string): Promise<void> {
  const field = parts().getByLabel(label, { exact: true });
  await field.fill(text);
  await field.press("Enter");
}

it("puts a second stencil beside the first, and places each by itself", async () => {
  await editor.take(null, "parts");
  for (const name of ["base.obj", "hat.obj"]) {
    await editor.drop(name, PYRAMID);
    const dialog = editor.page.getByRole("dialog", { name: `Open ${name}` });
    await dialog.getByRole("button", { name: name === "base.obj" ? "Open" : "Add to this design" }).click();
    await parts()
      .getByRole("button", { name: new RegExp(`^${name}`) })
      .waitFor();
  }
  await editor.loopback.ask("edit", {
    request: {
      edit: "draw",
      through_mm: [
        [0, 0, 80],
        [60, 0, 80],
      ],
    },
  });
  await editor.reload("parts");
  await parts().getByText("2 stencils").first().waitFor();
  expect((await stencils()).map(({ name }) => name)).toEqual(["base.obj", "hat.obj"]);
  await editor.isCleanNow("parts");

  await parts()
    .getByRole("button", { name: /^hat\.obj/ })
    .click();
  await fill("Centre of the stencil, Z, mm", "60");
  await fill("Rotation of the stencil, Z, °", "45");
  await fill("Scale", "50");
  await until(async () => (await stencils())[1]?.placement).toEqual({
    shift_mm: [0, 0, 40],
    turn_deg: [0, 0, 45],
    scale: 0.5,
  });
  expect((await stencils())[0]?.placement).toEqual({ shift_mm: [0, 0, 0], turn_deg: [0, 0, 0], scale: 1 });
  await parts().getByText("30.0 mm × 30.0 mm × 20.0 mm").waitFor();
  await editor.isCleanNow("parts-placed");

  // The tip of the small one is traced where it lies.
  const sight = await Sight.from(editor.page, "front", [
    [0, 0, 0],
    [60, 60, 80],
  ]);
  await editor.page.keyboard.press("t");
  const tip = sight.at([30, 30, 70]);
  await editor.page.mouse.move(tip.x - 3, tip.y - 2);
  await editor.page.mouse.move(tip.x, tip.y);
  await editor.page.locator(".hover-card", { hasText: "Corner of the stencil" }).waitFor();
  await editor.page.keyboard.press("Escape");
  await editor.page.keyboard.press("v");
});

it("moves the chosen stencil with the gizmo, as one thing to undo", async () => {
  const sight = await Sight.from(editor.page, "front", [
    [0, 0, 0],
    [60, 60, 80],
  ]);
  const middle = sight.at([30, 30, 60]);
  // The arrow along z.
  await editor.page.mouse.move(middle.x, middle.y - 40);
  await editor.page.mouse.down();
  await editor.page.mouse.move(middle.x, middle.y - 60, { steps: 4 });
  await editor.isCleanNow("parts-moving");
  await editor.page.mouse.move(middle.x, middle.y - 80, { steps: 4 });
  await editor.page.mouse.up();
  await until(async () => ((await stencils())[1]?.placement.shift_mm?.[2] ?? 0) > 41).toBe(true);
  const [x, y] = (await stencils())[1]?.placement.shift_mm ?? [];
  expect([x, y]).toEqual([0, 0]);
  await editor.page.keyboard.press("Control+z");
  await until(async () => (await stencils())[1]?.placement.shift_mm).toEqual([0, 0, 40]);
});

it("turns the chosen stencil with an arc of the gizmo, as it lies", async () => {
  const sight = await Sight.from(editor.page, "front", [
    [0, 0, 0],
    [60, 60, 80],
  ]);
  const { x, y } = sight.at([30, 30, 60]);
  const rows = async () => (await stencils())[1]?.surface?.matrix.map((row) => row.slice(0, 3)) ?? [];
  const placement = (await stencils())[1]?.placement;
  const [across = [], deep = [], up = []] = await rows();
  const beside = 52 * Math.SQRT1_2;
  await editor.page.mouse.move(x + beside, y - beside);
  await editor.page.mouse.down();
  await editor.page.mouse.move(x + 60, y - 2, { steps: 4 });
  await editor.page.getByText("about y 45.0°").waitFor();
  await editor.isCleanNow("parts-turning");
  await editor.page.mouse.move(x + beside, y + beside, { steps: 4 });
  await editor.page.mouse.up();
  // A quarter about y: what went up goes along x, and what went along x goes down.
  const near = (row: number[]) => row.map((value) => expect.closeTo(value, 9));
  await until(rows).toEqual([near(up), near(deep), near(across.map((value) => -value))]);
  expect((await stencils())[1]?.placement.shift_mm).toEqual([0, 0, 40]);
  await editor.page.keyboard.press("Control+z");
  await until(async () => (await stencils())[1]?.placement).toEqual(placement);
});

it("names, colours, hides and removes a stencil", async () => {
  await fill("Name of the stencil", "Hat");
  await parts().getByRole("button", { name: "Colour of Hat" }).click();
  await editor.button("Teal").click();
  await parts().getByRole("button", { name: "Hide Hat" }).click();
  await until(async () => (await stencils())[1]?.look).toEqual({ name: "Hat", colour: "#1f9aa8", hidden: true });
  await until(() => editor.phrase("parts")).toBe("1 part · 2 stencils · 1 hidden");
  await parts().getByRole("button", { name: "Show Hat" }).click();
  await parts().getByRole("button", { name: "Remove base.obj" }).click();
  await until(async () => (await stencils()).map(({ name }) => name)).toEqual(["Hat"]);
});

it("names, colours and hides a part of the wire, which is bent all the same", async () => {
  await editor.loopback.ask("edit", {
    request: {
      edit: "draw",
      through_mm: [
        [0, 0, 120],
        [60, 0, 120],
        [60, 60, 120],
      ],
    },
  });
  await editor.reload("parts");
  await parts()
    .getByRole("button", { name: /^Part 2/ })
    .click();
  await fill("Name of the part", "Top");
  await parts().getByRole("button", { name: "Colour of Top" }).click();
  await editor.button("Magenta").click();
  await parts().getByText("2 edges · 120.0 mm").waitFor();
  await editor.isCleanNow("parts-coloured");
  const before = (await editor.design()).edges.length;
  await parts().getByRole("button", { name: "Hide Top" }).click();
  await until(() => editor.phrase("parts")).toBe("2 parts · 1 stencil · 1 hidden");
  await editor.isCleanNow("parts-hidden");
  expect((await editor.design()).edges).toHaveLength(before);
  // What is hidden is not selected with everything.
  await editor.page.keyboard.press("Control+a");
  await editor.page.keyboard.press("Delete");
  await until(async () => (await editor.design()).edges.length).toBe(2);
});

it("makes construction lines of edges, snaps to them, and makes edges of them again", async () => {
  await editor.take(null, "parts", "edit");
  const line: [number, number, number][] = [
    [0, 0, 0],
    [0, 0, 60],
  ];
  await editor.loopback.ask("edit", { request: { edit: "draw", through_mm: line } });
  await editor.reload("parts", "edit");
  await editor
    .section("edit")
    .getByText(/^2 vertices/)
    .waitFor();
  await editor.page.locator(".viewport canvas").focus();
  for (const key of ["a", "k"]) await editor.page.keyboard.press(key);
  const lines = parts().getByRole("list", { name: "Construction lines" }).getByRole("listitem");
  await lines.filter({ hasText: "60.0 mm" }).waitFor();
  const state = (await editor.design()).state;
  expect([state.construction_mm, (await editor.design()).edges]).toEqual([[line], []]);
  // A strand begins at its very end, and at its middle.
  await editor.page.keyboard.press("d");
  const sight = await Sight.from(editor.page, "front", line);
  for (const at of [
    [0, 0, 60],
    [0, 0, 30],
  ] as const) {
    const { x, y } = sight.at(at);
    await editor.page.mouse.move(x + 3, y + 2);
    await editor.page.mouse.down();
    await editor.page.mouse.up();
  }
  await until(async () => (await editor.design()).vertices.map(({ at_mm }) => at_mm)).toEqual([
    [0, 0, 60],
    [0, 0, 30],
  ]);
  await editor.page.keyboard.press("Escape");
  await editor.page.keyboard.press("Control+z");
  await until(async () => (await editor.design()).vertices).toEqual([]);
  await lines.first().hover();
  await editor.isClean("parts-construction");
  await parts().getByRole("button", { name: "Make edge of Line 1" }).click();
  await until(async () => (await editor.design()).edges.length).toBe(1);
  await lines.first().waitFor({ state: "detached" });
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("Control+z");
  await lines.first().waitFor();
  await parts().getByRole("button", { name: "Delete Line 1" }).click();
  await lines.first().waitFor({ state: "detached" });
  expect((await editor.design()).vertices).toEqual([]);
});

it("adds a drawing to the design that is open, from either menu", async () => {
  await editor.take("house", "parts");
  const edges = (await editor.design()).edges.length;
  for (const [name, how] of [
    ["two.obj", "drop"],
    ["three.obj", "stencil"],
    ["four.obj", "menu"],
  ] as const) {
    const drawing = "v 0 0 500\nv 70 0 500\nv 70 50 500\nl 1 2 3\n";
    if (how === "drop") await editor.drop(name, drawing);
    else {
      const file = join(editor.loopback.home, name);
      writeFileSync(file, drawing);
      await editor.choose(file, async () => {
        if (how === "stencil") return parts().getByRole("button", { name: "Open stencil…" }).click();
        return editor.menu("File", "Add to this design…");
      });
    }
    const dialog = editor.page.getByRole("dialog", { name: `Open ${name}` });
    const before = (await editor.design()).edges.length;
    await dialog.getByRole("button", { name: "Add to this design" }).waitFor();
    await editor.isCleanNow(`parts-add-${how}`);
    expect(await dialog.getByRole("button", { name: "Open", exact: true }).count()).toBe(how === "drop" ? 1 : 0);
    await dialog.getByRole("button", { name: "Add to this design" }).click();
    await dialog.waitFor({ state: "detached" });
    expect((await editor.design()).edges.length).toBe(before + 2);
  }
  expect((await editor.design()).edges.length).toBe(edges + 6);
  // A design asks nothing.
  const saved = join(editor.loopback.home, "same.wirebend");
  await editor.loopback.ask("save", { path: saved });
  await editor.choose(saved, () => editor.menu("File", "Add to this design…"));
  await until(async () => (await editor.design()).edges.length).toBe(2 * (edges + 6));
});
