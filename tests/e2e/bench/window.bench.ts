import { type ChildProcess, execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { deb, discard, type Unpacked, unpack } from "../support/installed.ts";
import { pictures, root } from "../support/places.ts";
import { Screen } from "../support/screen.ts";
import { type Figure, hand, median, megabytes, seconds } from "./figures.ts";
import { family, nameOf, pss, used } from "./processes.ts";
import { Windows } from "./windows.ts";

const STARTS = 5;
/** By a user who has never started it: the toolkit has kept nothing for them yet. */
const FIRST_STARTS = 3;
const [WIDTH, HEIGHT] = [1440, 900];
/** The middle of the view, where nothing lies over it: part of the width and of the height. */
const VIEW = { left: 0.15, right: 0.55, top: 0.3, bottom: 0.7 } as const;
/** Nothing changes for so long once it is there, ms. */
const STILL = 3000;
const IDLE = 20_000;
/** How often the screen is looked at, ms: each look costs the window a little. */
const LOOK = 40;

let unpacked: Unpacked;
let screen: Screen;
let windows: Windows;
let folder: string;
let design: string;

/** The person's folders, all in one. */
const surroundings = (home: string): NodeJS.ProcessEnv => ({
  ...process.env,
  HOME: home,
  XDG_CONFIG_HOME: `${home}/config`,
  XDG_DATA_HOME: `${home}/data`,
  XDG_CACHE_HOME: `${home}/cache`,
  DISPLAY: screen.display,
});

beforeAll(async () => {
  unpacked = unpack();
  screen = await Screen.open({ width: WIDTH, height: HEIGHT });
  windows = await Windows.of(screen.display);
  folder = mkdtempSync(join(tmpdir(), "wirebend-bench-"));
  design = `${folder}/bunny.wirebend`;
  execFileSync(unpacked.commands, ["import", `${root}examples/bunny.obj`, "--face-edges", "-o", design], {
    env: surroundings(folder),
    stdio: "ignore",
  });
});

afterAll(async () => {
  windows.close();
  await screen.close();
  discard(unpacked);
  rmSync(folder, { recursive: true, force: true });
});

interface Started {
  /** From the start until the window is there, until the middle of the view is as it stays, and the whole window: ms. */
  readonly mapped: number;
  readonly seen: number;
  readonly whole: number;
  readonly bytes: number;
  readonly processes: readonly string[];
  /** Part of a processor that all of it uses while nothing happens, and the program itself without its toolkit's processes. */
  readonly idle: { readonly all: number; readonly own: number } | null;
}

/** When the middle of the view, and anything at all, changed last. */
async function watch(began: number): Promise<{ seen: number; whole: number }> {
  let before = screen.pixels().bytes;
  let [seen, whole] = [began, began];
  for (let now = began; now - whole < STILL; ) {
    await new Promise((resolve) => setTimeout(resolve, LOOK));
    const { bytes, lineBytes, from } = screen.pixels();
    now = performance.now();
    if (!bytes.equals(before)) {
      whole = now;
      for (let y = Math.round(HEIGHT * VIEW.top); y < HEIGHT * VIEW.bottom; y += 1) {
        const [left, right] = [VIEW.left, VIEW.right].map(
          (part) => from + y * lineBytes + Math.round(WIDTH * part) * 4,
        );
        if (bytes.compare(before, left, right, left, right) === 0) continue;
        seen = now;
        break;
      }
    }
    before = bytes;
  }
  return { seen, whole };
}

/** Ends the window and what it has started. */
async function end(child: ChildProcess, pids: readonly number[]): Promise<void> {
  const over = new Promise((resolve) => child.once("close", resolve));
  child.kill();
  await over;
  for (const pid of pids) {
    try {
      process.kill(pid);
    } catch {
      // It went with the window.
    }
  }
}

const percent = (part: number): string => `${(part * 100).toFixed(2)} %`;

const newHome = (): string => mkdtempSync(join(folder, "home-"));

async function start(home: string, last: boolean): Promise<Started> {
  const there = windows.mapped(WIDTH / 2).then(() => performance.now());
  const began = performance.now();
  const child = spawn(unpacked.window, [design], { env: surroundings(home), stdio: ["ignore", "ignore", "pipe"] });
  let said = "";
  child.stderr?.on("data", (text: Buffer) => {
    said += text.toString();
  });
  const died = new Promise<never>((_, reject) => {
    child.once("error", reject);
    child.once("exit", (code) => reject(new Error(`the window ended with ${code}: ${said}`)));
  });
  try {
    const mapped = await Promise.race([there, died]);
    const { seen, whole } = await Promise.race([watch(mapped), died]);
    const pids = family(child.pid ?? 0);
    const bytes = pids.reduce((sum, pid) => sum + pss(pid), 0);
    let idle: Started["idle"] = null;
    if (last) {
      mkdirSync(pictures, { recursive: true });
      writeFileSync(`${pictures}/bench-window.png`, screen.picture());
      const own = [child.pid ?? 0];
      const before = { all: used(pids), own: used(own) };
      await Promise.race([new Promise((resolve) => setTimeout(resolve, IDLE)), died]);
      idle = { all: (used(pids) - before.all) / IDLE, own: (used(own) - before.own) / IDLE };
    }
    return {
      mapped: mapped - began,
      seen: seen - began,
      whole: whole - began,
      bytes,
      processes: pids.map(nameOf),
      idle,
    };
  } finally {
    died.catch(() => {});
    await end(child, family(child.pid ?? 0));
  }
}

it("measures the installed window", async () => {
  // It reads the program from the disk.
  const cold = await start(newHome(), false);
  const first: Started[] = [];
  for (let run = 0; run < FIRST_STARTS; run += 1) first.push(await start(newHome(), false));
  const starts: Started[] = [];
  const home = newHome();
  await start(home, false);
  for (let run = 0; run < STARTS; run += 1) starts.push(await start(home, run === STARTS - 1));
  const idle = starts.at(-1)?.idle ?? { all: NaN, own: NaN };
  const { size, mtime } = statSync(deb());
  expect(starts[0]?.processes.length).toBeGreaterThan(1);
  const rows: Figure[] = [
    { what: "the .deb", measured: megabytes(size), aim: "≤ 15 MB" },
    {
      what: "from the start until the window is mapped",
      measured: seconds(median(starts.map(({ mapped }) => mapped))),
      aim: "≤ 1 s",
    },
    {
      what: "until the design, its checks on it, is in the view",
      measured: seconds(median(starts.map(({ seen }) => seen))),
      aim: "≤ 2 s",
    },
    {
      what: "the same where a person has never started it before",
      measured: seconds(median(first.map(({ seen }) => seen))),
      aim: "≤ 2 s",
    },
    {
      what: "until nothing in the window changes any more",
      measured: seconds(median(starts.map(({ whole }) => whole))),
      aim: null,
    },
    {
      what: "memory of all its processes (PSS)",
      measured: megabytes(median(starts.map(({ bytes }) => bytes))),
      aim: "≤ 450 MB",
    },
    { what: "processor used in 20 s in which nothing happens", measured: percent(idle.all), aim: "0 %" },
    { what: "of it the program, without its toolkit's processes", measured: percent(idle.own), aim: "0 %" },
  ];
  hand("4-window", {
    title: "the installed window on the bunny",
    rows,
    notes: [
      `${basename(deb())} of ${mtime.toISOString().slice(0, 16).replace("T", " ")} UTC, unpacked, on a screen in memory without a graphics card.`,
      `Medians of ${STARTS} starts, and of ${FIRST_STARTS} first ones, in which the shaders of the view are compiled for the processor. Not counted: the very`,
      `first (mapped after ${seconds(cold.mapped)}, in the view after ${seconds(cold.seen)}), which reads the program from the disk. Mapped as the screen reports it;`,
      `in the view when the middle of the view does not change any more; looked at every ${LOOK} ms. Processes: ${[...new Set(starts.at(-1)?.processes)].join(", ")}.`,
    ],
  });
});
