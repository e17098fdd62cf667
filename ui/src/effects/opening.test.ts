// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const nothing = () => () => {};
const platform = vi.hoisted(() => ({
  ask: vi.fn(),
  stop: vi.fn(),
  listen: vi.fn(),
  onDrop: vi.fn(),
  onOpen: vi.fn(),
  filesToOpen: vi.fn(),
  onClose: vi.fn(),
  setTitle: vi.fn(),
}));
vi.mock("../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { useDesign } from "../state/design/design";
import { begun } from "../state/files/beginning";
import { open } from ".";

let end = () => {};
beforeEach(() => {
  for (const mock of [platform.listen, platform.onDrop, platform.onOpen, platform.onClose])
    mock.mockImplementation(nothing);
  platform.filesToOpen.mockResolvedValue([]);
  platform.ask.mockRejectedValue(new Error("nobody is there"));
  useDesign.setState({ state: null });
  end = open();
});
afterEach(() => end());

describe("what the window begins with", () => {
  const PATIENCE = 500;
  /** The answer to what is asked for under this name comes later; the others are refused. */
  function answered(name: string): (answer: unknown) => void {
    let later: (answer: unknown) => void = () => {};
    const answer = new Promise((resolve) => (later = resolve));
    platform.ask.mockImplementation((ask: string) =>
      ask === name ? answer : Promise.reject(new Error("nobody is there")),
    );
    return later;
  }
  const isOver = async (promise: Promise<unknown>): Promise<boolean> => {
    let over = false;
    void promise.then(() => (over = true));
    await vi.advanceTimersByTimeAsync(1);
    return over;
  };
  beforeEach(() => {
    end();
    vi.useFakeTimers();
    platform.ask.mockClear();
  });
  afterEach(() => vi.useRealTimers());

  it("is waited for, the first of the files that it was started with too", async () => {
    platform.filesToOpen.mockResolvedValue(["/there/bunny.wirebend", "/there/house.wirebend"]);
    const look = answered("look");
    end = open();
    const there = begun();
    expect(await isOver(there)).toBe(false);
    look(null);
    expect(await isOver(there)).toBe(true);
    expect(platform.ask.mock.calls.filter(([ask]) => ask === "look")).toEqual([
      ["look", { design: { input: { file: "/there/bunny.wirebend" } } }],
    ]);
  });

  it("comes before a file that is asked for meanwhile", async () => {
    platform.filesToOpen.mockResolvedValue(["/there/bunny.wirebend"]);
    const look = answered("look");
    end = open();
    const [hear] = platform.onOpen.mock.calls.at(-1) as [(path: string) => void];
    hear("/there/house.wirebend");
    const looks = () =>
      platform.ask.mock.calls
        .filter(([ask]) => ask === "look")
        .map(([, request]) => (request as { design: { input: { file: string } } }).design.input.file);
    await vi.advanceTimersByTimeAsync(1);
    expect(looks()).toEqual(["/there/bunny.wirebend"]);
    look(null);
    await vi.advanceTimersByTimeAsync(1);
    expect(looks()).toEqual(["/there/bunny.wirebend", "/there/house.wirebend"]);
  });

  it("is not waited for for long", async () => {
    platform.filesToOpen.mockReturnValue(new Promise(() => {}));
    end = open();
    const there = begun();
    await vi.advanceTimersByTimeAsync(PATIENCE - 10);
    expect(await isOver(there)).toBe(false);
    await vi.advanceTimersByTimeAsync(10);
    expect(await isOver(there)).toBe(true);
  });
});
