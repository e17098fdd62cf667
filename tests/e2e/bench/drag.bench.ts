import { afterEach, expect, it } from "vitest";
import { COMPOSITED, SMOOTH } from "../support/browser.ts";
import { Editor, until } from "../support/editor.ts";
import { Sight } from "../support/sight.ts";
import { type Figure, hand, ms, within } from "./figures.ts";
import { column, PLACES } from "./models.ts";
import { type Asked, install, type Move, type Recording, rate, recorded, set } from "./recorder.ts";

/** Of the column: at its outline in the view from the front, where no other is behind it. */
const VERTEX = 160;
const AT = PLACES[VERTEX] ?? [0, 0, 0];

/** A second of a mouse. */
const RATE = 60;
/** The pointer goes to and fro over a square of so many pixels: each of them once. */
const SIDE = 16;

let editor: Editor;

/** With the column open, and where its vertex is taken hold of. */
async function begin(browserArguments: readonly string[]): Promise<{ sight: Sight; press: { x: number; y: number } }> {
  editor = await Editor.open({}, () => {}, [SMOOTH, ...browserArguments]);
  await install(editor.page);
  const bytes = [...Buffer.from(column())];
  await editor.loopback.ask("open", { design: { input: { bytes: { name: "column.obj", bytes } }, units: "mm" } });
  await editor.reload("check");
  await editor.section("check").getByText("One wire runs through every edge").waitFor();
  const sight = await Sight.from(editor.page, "front", PLACES);
  const seen = sight.at(AT);
  return { sight, press: { x: Math.round(seen.x), y: Math.round(seen.y) } };
}
afterEach(() => editor?.end());

/** An answer that was shown, and the move that it is of. */
interface Answered {
  readonly move: Move;
  readonly asked: number;
  readonly answered: number;
  readonly begun: number;
  readonly framed: number;
}

/** Drags the vertex with the mouse, and gives it up. */
async function drag(press: { x: number; y: number }): Promise<Recording> {
  const { page } = editor;
  const { mouse, keyboard } = page;
  await mouse.move(press.x, press.y);
  await page.locator(".hover-card", { hasText: `Vertex ${VERTEX}` }).waitFor();
  await mouse.down();
  // Free of the grid and of what is near: each pixel is another place.
  await keyboard.down("Control");
  await set(page, { moves: [], asked: [] });
  const begun = performance.now();
  const sent: Promise<void>[] = [];
  for (let step = 0; step < SIDE * SIDE; step += 1) {
    const [row, k] = [Math.floor(step / SIDE), step % SIDE];
    const [x, y] = [(row % 2 === 0 ? k : SIDE - 1 - k) - SIDE / 2, row - SIDE / 2];
    await new Promise((resolve) => setTimeout(resolve, begun + (step * 1000) / RATE - performance.now()));
    // A mouse does not wait until it was heard.
    sent.push(mouse.move(press.x + x, press.y + y));
  }
  await Promise.all(sent);
  await until(async () => (await recorded(page)).asked.every(({ framed }) => framed !== null)).toBe(true);
  const kept = await recorded(page);
  await keyboard.up("Control");
  await keyboard.press("Escape");
  await mouse.up();
  expect((await editor.vertex(VERTEX))[0]).toBeCloseTo(AT[0], 9);
  return kept;
}

/** The last move before the question that went where the question is about: a pixel from every other. */
function moveOf({ place, asked }: Asked, moves: readonly Move[], sight: Sight, press: { x: number; y: number }): Move {
  const [x, y] = [press.x + (place[0] - AT[0]) / sight.pixel, press.y - (place[2] - AT[2]) / sight.pixel];
  const found = moves.findLast((move) => move.at <= asked && Math.hypot(move.x - x, move.y - y) < 0.5);
  if (!found) throw new Error(`no move went to ${x.toFixed(2)}, ${y.toFixed(2)}`);
  return found;
}

/** What was answered, after making sure that what the frame shows is of that place. */
function answeredOf({ asked, moves }: Recording, sight: Sight, press: { x: number; y: number }): Answered[] {
  return asked.map((one, index) => {
    if (one.answered === null || one.begun === null || one.framed === null)
      throw new Error("a question was not answered");
    // Of two answers in one frame the later one is seen.
    if (asked[index + 1]?.framed !== one.framed)
      expect(one.shown.replaceAll(/\s/g, "")).toBe(`${(one.length_mm ?? NaN).toFixed(1)}mm`);
    return {
      move: moveOf(one, moves, sight, press),
      asked: one.asked,
      answered: one.answered,
      begun: one.begun,
      framed: one.framed,
    };
  });
}

/** Drags several times, and says what came of it. */
async function drags(
  times: number,
  draws: boolean,
  sight: Sight,
  press: { x: number; y: number },
): Promise<{ rows: Figure[]; notes: string[] }> {
  await set(editor.page, { draws });
  const all: Answered[] = [];
  const every: number[] = [];
  const gaps: number[] = [];
  let [heard, feasible, mm] = [0, 0, 0];
  for (let run = 0; run < times; run += 1) {
    const kept = await drag(press);
    const answered = answeredOf(kept, sight, press);
    all.push(...answered);
    heard += kept.moves.length;
    feasible += kept.asked.filter((one) => one.feasible).length;
    mm = Math.max(mm, ...kept.asked.map(({ place }) => Math.hypot(place[0] - AT[0], place[2] - AT[2])));
    gaps.push(...kept.moves.slice(1).map(({ at }, index) => at - (kept.moves[index]?.at ?? at)));
    // A move that was never asked about is answered with the next that was.
    for (const move of kept.moves) {
      const next = answered.find((one) => one.move.at >= move.at);
      if (next) every.push(next.framed - move.at);
    }
  }
  const sent = times * SIDE * SIDE;
  const part = (of: (one: Answered) => number, share: number): string => ms(within(all.map(of), share));
  const whole = ({ move, framed }: Answered): number => framed - move.at;
  const answer = ({ asked, answered }: Answered): number => answered - asked;
  return {
    rows: [
      { what: "from a question to its answer in the page, 50 of 100", measured: part(answer, 0.5), aim: null },
      { what: "the same, 95 of 100 within", measured: part(answer, 0.95), aim: "≤ 33 ms" },
      { what: "from a move to the frame that shows its checks, 50 of 100", measured: part(whole, 0.5), aim: null },
      { what: "the same, 95 of 100 within", measured: part(whole, 0.95), aim: "≤ 33 ms" },
      {
        what: "  of it until it is asked, 50 of 100",
        measured: part(({ move, asked }) => asked - move.at, 0.5),
        aim: null,
      },
      {
        what: "  of it until the next frame is begun to be drawn, 50 of 100",
        measured: part(({ answered, begun }) => begun - answered, 0.5),
        aim: null,
      },
      {
        what: "  of it until the page is done with it, 50 of 100",
        measured: part(({ begun, framed }) => framed - begun, 0.5),
        aim: null,
      },
      { what: "moves that were answered, of those that were made", measured: `${all.length}/${sent}`, aim: null },
      {
        what: "every move heard, until checks of it or a later one, 95 of 100",
        measured: ms(within(every, 0.95)),
        aim: null,
      },
    ],
    notes: [
      `${sent} moves, ${(1000 / within(gaps, 0.5)).toFixed(0)} a second, to ${mm.toFixed(0)} mm away; ${feasible} of ${all.length} answers say: within the limits.`,
      `${sent - heard} moves came to the page together with the next, ${heard - all.length} were overtaken by a newer one before they were asked.`,
    ],
  };
}

it("measures a drag without the drawing", async () => {
  // What does not draw needs no card that puts pictures together either: done by the processor, that alone takes 80 ms a frame.
  const { sight, press } = await begin([COMPOSITED, "--disable-gpu-compositing"]);
  const free = await rate(editor.page);
  await set(editor.page, { draws: false });
  // The first one is for the page's compiler.
  await drag(press);
  const { rows, notes } = await drags(3, false, sight, press);
  hand("1-drag", {
    title: "a vertex of 1000 edges dragged: draw commands left out",
    rows,
    notes: [
      `Chromium ${editor.page.context().browser()?.version() ?? ""}, which has ${free.toFixed(0)} frames a second while the page does nothing.`,
      ...notes,
      "A move counts from when the browser has it; a frame is done when the page has done its part of it. The draw commands of the view are",
      "counted and not carried out: that is a graphics card's work. Asked here over HTTP; the installed window asks through its toolkit.",
    ],
  });
});

it("measures a drag with it", async () => {
  const { sight, press } = await begin([COMPOSITED]);
  await drag(press);
  const { rows, notes } = await drags(1, true, sight, press);
  hand("2-drag-drawn", { title: "the same, drawn by the processor for want of a card", rows, notes });
});
