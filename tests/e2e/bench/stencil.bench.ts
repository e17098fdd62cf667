import { writeFileSync } from "node:fs";
import { afterAll, beforeAll, expect, it } from "vitest";
import { COMPOSITED, SMOOTH } from "../support/browser.ts";
import { Editor, until } from "../support/editor.ts";
import { Sight } from "../support/sight.ts";
import { type Figure, hand, median, ms, seconds, within } from "./figures.ts";
import { column, PLACES, surface, TRIANGLES } from "./models.ts";
import { install, recorded, rests, set } from "./recorder.ts";

const OPENINGS = 5;
/** Places of the pointer, from far and from near each. */
const HOVERS = 300;
const RATE = 60;

let editor: Editor;
let file: string;

beforeAll(async () => {
  editor = await Editor.open({}, () => {}, [COMPOSITED, SMOOTH]);
  await install(editor.page);
  const bytes = [...Buffer.from(column())];
  await editor.loopback.ask("open", { design: { input: { bytes: { name: "column.obj", bytes } }, units: "mm" } });
  await editor.reload("trace", "check");
  file = `${editor.loopback.home}/surface.stl`;
  writeFileSync(file, surface());
});
afterAll(() => editor?.end());

/** Opens the stencil; how long it takes until it asks, and from the answer until it is shown, ms. */
async function open(): Promise<{ asks: number; shows: number }> {
  const { page } = editor;
  await set(page, { chosen: null, dialog: null, said: null, shown: null, surface: TRIANGLES * 3, looks: 0 });
  await editor.choose(file, () => editor.button("Open stencil…").click());
  // The dialog looks a second time, which is over before a person has read it.
  await until(async () => (await recorded(page)).looks).toBe(2);
  await editor.button("Add to this design").click();
  await editor
    .section("trace")
    .getByText(/^200.000 faces$/)
    .waitFor();
  await until(async () => (await recorded(page)).shown !== null).toBe(true);
  const { chosen, dialog, said, shown } = await recorded(page);
  if (chosen === null || dialog === null || said === null || shown === null)
    throw new Error("a part of opening was not seen");
  return { asks: dialog - chosen, shows: shown - said };
}

/** Goes over what is in the view, and says how long the page worked on each frame before it drew. */
async function hover(sight: Sight, width: number, height: number): Promise<number[]> {
  const { page } = editor;
  const middle = sight.at([0, 0, (PLACES.at(-1)?.[2] ?? 0) / 2]);
  await page.mouse.move(middle.x, middle.y);
  await rests(page);
  await set(page, { work: [] });
  const begun = performance.now();
  const sent: Promise<void>[] = [];
  for (let step = 0; step < HOVERS; step += 1) {
    // Up along the surface, from side to side.
    const [x, y] = [Math.sin(step / 7) * width, (step / HOVERS - 0.5) * height];
    await new Promise((resolve) => setTimeout(resolve, begun + (step * 1000) / RATE - performance.now()));
    sent.push(page.mouse.move(middle.x + x, middle.y + y));
  }
  await Promise.all(sent);
  await rests(page);
  await page.mouse.move(middle.x + 1, middle.y + 1);
  await page.locator(".hover-card", { hasText: /stencil|Vertex|edge/ }).waitFor();
  return (await recorded(page)).work;
}

it("measures a stencil", async () => {
  const { page } = editor;
  const opened: { asks: number; shows: number }[] = [];
  for (let run = 0; run < OPENINGS; run += 1) {
    if (run > 0) {
      await editor.button("Remove").click();
      await editor.section("trace").getByText("no stencil").waitFor();
    }
    await rests(page);
    opened.push(await open());
  }

  const sight = await Sight.from(page, "front", PLACES);
  await page.keyboard.press("t");
  await set(page, { draws: false });
  // The first one is for the page's compiler.
  await hover(sight, 50, 600);
  const far = await hover(sight, 50, 600);
  const { calls } = await recorded(page);
  for (let turn = 0; turn < 6; turn += 1) await page.mouse.wheel(0, -240);
  const near = await hover(sight, 300, 600);
  const work = [...far, ...near];
  expect(work.length).toBeGreaterThan(0);
  await set(page, { draws: true });

  await page.keyboard.press("q");
  await page.mouse.move(5, 5);
  await rests(page);
  const before = (await recorded(page)).frames;
  await new Promise((resolve) => setTimeout(resolve, 2000));
  const idle = (await recorded(page)).frames - before;

  const rows: Figure[] = [
    {
      what: "chosen until shown with its search tree, without the answer",
      measured: seconds(median(opened.map(({ asks, shows }) => asks + shows))),
      aim: "≤ 2 s",
    },
    {
      what: "  of it from the choice until it asks what the numbers are",
      measured: seconds(median(opened.map(({ asks }) => asks))),
      aim: null,
    },
    {
      what: "  of it from the answer until the frame that shows it",
      measured: seconds(median(opened.map(({ shows }) => shows))),
      aim: null,
    },
    { what: "finding what a click would snap to, 50 of 100", measured: ms(within(work, 0.5)), aim: null },
    { what: "the same, 99 of 100 within", measured: ms(within(work, 0.99)), aim: "≤ 5 ms" },
    { what: "draw calls of a frame, tracing", measured: String(calls), aim: null },
    { what: "frames drawn in 2 s in which nothing happens", measured: String(idle), aim: "0" },
  ];
  hand("3-stencil", {
    title: "a stencil of 200,000 triangles under 1000 edges",
    rows,
    notes: [
      `Median of ${OPENINGS} openings of a binary STL of 10 MB, which the browser also hands over to the other side; the installed window gives a path.`,
      `Snapping at ${work.length} places of the pointer, from far and from near: all that the page works in a frame before it draws; nothing is drawn meanwhile,`,
      "so that each move has a frame. Opening is drawn by the processor, for want of a graphics card.",
    ],
  });
});
