import type { Page } from "playwright-core";

/** A move of the pointer as the page hears it. Times in ms of the page's clock. */
export interface Move {
  /** When the browser had it. */
  readonly at: number;
  /** CSS pixels of the window. */
  readonly x: number;
  readonly y: number;
}

/** A check that was asked while something is dragged. */
export interface Asked {
  /** Where the first vertex is dragged to, mm. */
  readonly place: readonly [number, number, number];
  readonly asked: number;
  /** When its answer was read, and what it says. */
  answered: number | null;
  length_mm: number | null;
  feasible: boolean;
  /** When the first frame afterwards begins to be drawn. */
  begun: number | null;
  /** When the page was done with it, and the length that its status bar says. */
  framed: number | null;
  shown: string;
}

/** What is recorded in the page. */
export interface Recording {
  moves: Move[];
  asked: Asked[];
  /** Of each frame that a move brought about: its work before the drawing, ms. */
  work: number[];
  /** Frames drawn, and the draw calls of the last. */
  frames: number;
  calls: number;
  /** Whether what is to be drawn is drawn: without a graphics card it takes the processor longer than all of the rest. */
  draws: boolean;
  /** Of opening a file: chosen, first asked about, said how, and shown with a surface of `surface` corners. */
  chosen: number | null;
  dialog: number | null;
  said: number | null;
  shown: number | null;
  surface: number;
  /** Files that were looked into. */
  looks: number;
}

/** Runs in the page before its scripts: listens to what goes in and out of the editor, which knows nothing of it. */
function record(): void {
  const kept: Recording = {
    moves: [],
    asked: [],
    work: [],
    frames: 0,
    calls: 0,
    draws: true,
    chosen: null,
    dialog: null,
    said: null,
    shown: null,
    surface: Infinity,
    looks: 0,
  };
  (window as unknown as { record: Recording }).record = kept;
  /** Handed to the editor, and not drawn yet. */
  let waiting: Asked[] = [];
  /** To be called when the page has done its part of the frame. */
  let after: ((now: number) => void)[] = [];
  let cleared: number | null = null;
  let [moving, moved, working] = [false, false, false];

  // A message comes after styles, layout and painting of the frame in which it was sent.
  const channel = new MessageChannel();
  channel.port1.onmessage = () => {
    const now = performance.now();
    const all = after;
    after = [];
    for (const one of all) one(now);
  };
  const afterFrame = (work: (now: number) => void): void => {
    after.push(work);
    if (after.length === 1) channel.port2.postMessage(null);
  };

  const passive = { passive: true } as const;
  // The first word of a move: the later one comes with the frame.
  window.addEventListener(
    "pointerrawupdate",
    (event) => {
      const { timeStamp, clientX, clientY } = event as PointerEvent;
      kept.moves.push({ at: timeStamp, x: clientX, y: clientY });
    },
    { ...passive, capture: true },
  );
  window.addEventListener(
    "pointermove",
    () => {
      moving = true;
      moved = true;
    },
    { ...passive, capture: true },
  );
  window.addEventListener(
    "pointermove",
    () => {
      moving = false;
    },
    passive,
  );
  window.addEventListener(
    "click",
    ({ timeStamp }) => {
      kept.said = timeStamp;
    },
    { ...passive, capture: true },
  );

  // The view's own callbacks: what a move asks for, and what such a one asks for itself.
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (work) => {
    if (!moving && !working) return request(work);
    return request((time) => {
      const counts = moved;
      moved = false;
      working = true;
      cleared = null;
      const begun = performance.now();
      work(time);
      if (counts) kept.work.push((cleared ?? performance.now()) - begun);
      working = false;
    });
  };

  // Each picture begins with clearing its colours; depth alone is cleared between its parts.
  const gl = WebGL2RenderingContext.prototype;
  const { clear, drawElements, drawArrays, drawElementsInstanced, drawArraysInstanced } = gl;
  gl.clear = function (mask) {
    if (mask & this.COLOR_BUFFER_BIT) {
      cleared ??= performance.now();
      kept.frames += 1;
      kept.calls = 0;
      const drawn = waiting;
      waiting = [];
      if (drawn.length > 0) {
        const shown =
          [...document.querySelectorAll(".status-figures div")]
            .find((one) => one.querySelector("dt")?.textContent === "Wire")
            ?.querySelector("dd")?.textContent ?? "";
        const begun = performance.now();
        for (const one of drawn) one.begun = begun;
        afterFrame((now) => drawn.forEach((one) => Object.assign(one, { framed: now, shown })));
      }
    }
    if (kept.draws) clear.call(this, mask);
  };
  gl.drawElements = function (mode, count, ...rest) {
    kept.calls += 1;
    if (count >= kept.surface && kept.shown === null)
      afterFrame((now) => {
        kept.shown ??= now;
      });
    if (kept.draws) drawElements.call(this, mode, count, ...rest);
  };
  gl.drawArrays = function (...words) {
    kept.calls += 1;
    if (kept.draws) drawArrays.apply(this, words);
  };
  gl.drawElementsInstanced = function (...words) {
    kept.calls += 1;
    if (kept.draws) drawElementsInstanced.apply(this, words);
  };
  gl.drawArraysInstanced = function (...words) {
    kept.calls += 1;
    if (kept.draws) drawArraysInstanced.apply(this, words);
  };

  const { fetch } = window;
  window.fetch = async (to, init) => {
    const text = typeof init?.body === "string" ? init.body : "{}";
    const { ask, moved } = JSON.parse(text) as { ask?: string; moved?: { at_mm: [number, number, number] }[] };
    const place = ask === "check" ? moved?.[0]?.at_mm : undefined;
    const asked: Asked | null = place
      ? {
          place,
          asked: performance.now(),
          answered: null,
          length_mm: null,
          feasible: false,
          begun: null,
          framed: null,
          shown: "",
        }
      : null;
    if (asked) kept.asked.push(asked);
    const answer = await fetch(to, init);
    if (ask === "look") kept.looks += 1;
    if (!asked) return answer;
    const json = answer.json.bind(answer);
    answer.json = async () => {
      const value = (await json()) as { feasible: boolean; wires: { length_mm: number | null }[] };
      asked.answered = performance.now();
      asked.feasible = value.feasible;
      asked.length_mm = value.wires.length === 1 ? (value.wires[0]?.length_mm ?? null) : null;
      waiting.push(asked);
      return value;
    };
    return answer;
  };

  const { arrayBuffer } = Blob.prototype;
  Blob.prototype.arrayBuffer = function () {
    kept.chosen = performance.now();
    return arrayBuffer.call(this);
  };
  new MutationObserver(() => {
    if (kept.dialog === null && document.querySelector("dialog[open]")) kept.dialog = performance.now();
  }).observe(document, { subtree: true, childList: true, attributeFilter: ["open"] });
}

/** From the next page that is loaded on. */
export const install = (page: Page): Promise<unknown> => page.addInitScript(record);

export const recorded = (page: Page): Promise<Recording> =>
  page.evaluate(() => (window as unknown as { record: Recording }).record);

/** Sets parts of the record, to begin anew. */
export const set = (page: Page, parts: Partial<Recording>): Promise<void> =>
  page.evaluate((parts) => void Object.assign((window as unknown as { record: Recording }).record, parts), parts);

/** Nothing is drawn any more. */
export const rests = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    const kept = (window as unknown as { record: Recording }).record;
    for (let before = -1; kept.frames !== before; ) {
      before = kept.frames;
      await new Promise((done) => setTimeout(done, 700));
    }
  });

/** Frames a second that the page has when it does nothing in them. */
export const rate = (page: Page): Promise<number> =>
  page.evaluate(async () => {
    const next = (): Promise<number> => new Promise((done) => requestAnimationFrame(done));
    const [frames, begun] = [60, await next()];
    let last = begun;
    for (let k = 0; k < frames; k += 1) last = await next();
    return (frames * 1000) / (last - begun);
  });
