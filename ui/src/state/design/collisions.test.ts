// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { Collisions, ContactReport, LiveCheck, WireFigures } from "../../generated/responses";
import { useMachines } from "../machine/machines";
import { lookForCollisions, stopCollisions, useCollisions } from "./collisions";
import { useDesign } from "./design";

const limits = { feasible: true, diagnostics: [], wires: [{ bends: 3 } as WireFigures], limits_unknown: null };
const finding = { code: "meets_machine" as const, severity: "warning" as const, message: "", help: "" };
const contact = { wire: 0, step: 1, finding } as ContactReport;
const found: Collisions = { checked: true, stopped: false, contacts: [contact], bodies: 6, estimates: 6 };
const moved = [{ vertex: 1, at: [0, 0, 0] as const }];

/** What is asked, and not answered yet. */
let answers: ((found: Collisions) => void)[] = [];
const asked = (name: string): number => platform.ask.mock.calls.filter(([ask]) => ask === name).length;
const answer = async (one: Collisions = found) => {
  answers.shift()?.(one);
  await vi.advanceTimersByTimeAsync(0);
};
const check = (of: LiveCheck = { ...limits }, dragged: typeof moved = []) => {
  useDesign.setState({ limits: of, dragged });
  lookForCollisions();
};
const stands = () => useCollisions.getState().stands;
const codes = () => useDesign.getState().check?.diagnostics.map(({ code }) => code);

beforeEach(() => {
  vi.useFakeTimers();
  answers = [];
  platform.ask.mockReset();
  platform.ask.mockImplementation((ask: string) =>
    ask === "collisions" ? new Promise((resolve) => answers.push(resolve)) : Promise.resolve({}),
  );
  useDesign.setState({ check: null, collisions: null, version: 1 });
});
afterEach(async () => {
  stopCollisions();
  while (answers.length > 0) await answer({ ...found, stopped: true });
  vi.useRealTimers();
});

describe("the check for collisions", () => {
  it("follows the other checks, and its findings are among theirs", async () => {
    check();
    expect(stands()).toBe("running");
    await answer();
    expect(stands()).toBe("done");
    expect(codes()).toEqual(["meets_machine"]);
  });

  it("does not look at what has no program", () => {
    check({ ...limits, wires: [{ bends: null } as WireFigures] });
    expect([stands(), asked("collisions")]).toEqual(["none", 0]);
  });

  it("is made while a person drags where the last one was quick, one at a time, and keeps what was found until then", async () => {
    check();
    await answer();
    check({ ...limits }, moved);
    check({ ...limits }, moved);
    check({ ...limits }, moved);
    expect(asked("collisions")).toBe(2);
    expect(useDesign.getState().collisions?.dragged).toBe(false);
    await answer({ ...found, contacts: [] });
    expect(asked("collisions")).toBe(3);
    expect(codes()).toEqual([]);
    await answer();
    expect([stands(), useDesign.getState().collisions?.dragged]).toEqual(["done", true]);
  });

  it("shows nothing of a profile before where that takes long, and takes no answer of it", async () => {
    const change = () => useMachines.setState(({ changes }) => ({ changes: changes + 1 }));
    check();
    await vi.advanceTimersByTimeAsync(400);
    await answer();
    check();
    expect(codes()).toEqual(["meets_machine"]);
    await vi.advanceTimersByTimeAsync(400);
    await answer();
    change();
    check();
    expect([stands(), codes()]).toEqual(["running", []]);
    change();
    await answer();
    expect(codes()).toEqual([]);
    check();
    await answer();
    expect([stands(), codes()]).toEqual(["done", ["meets_machine"]]);
  });

  it("shows nothing of a profile before where that is quick, either", async () => {
    check();
    await answer();
    check();
    expect(codes()).toEqual(["meets_machine"]);
    await answer();
    useMachines.setState(({ changes }) => ({ changes: changes + 1 }));
    check();
    expect([stands(), codes()]).toEqual(["running", []]);
  });

  it("waits for the end of the drag where the last one took long, and shows nothing of before", async () => {
    check();
    await vi.advanceTimersByTimeAsync(400);
    await answer();
    check({ ...limits }, moved);
    expect([stands(), asked("collisions"), codes()]).toEqual(["waiting", 1, []]);
    check();
    expect([stands(), asked("collisions")]).toEqual(["running", 2]);
  });

  it("stops what takes long when a later one is wanted, and takes no answer of a design that has changed", async () => {
    check();
    await vi.advanceTimersByTimeAsync(150);
    useDesign.setState({ version: 2 });
    check();
    expect(asked("stop-collisions")).toBe(1);
    await answer();
    expect(useDesign.getState().collisions).toBeNull();
    await answer({ ...found, contacts: [] });
    expect([stands(), useDesign.getState().collisions?.version]).toEqual(["done", 2]);
  });

  it("does not ask for a later one before the order to stop the one before is answered, which would stop it, too", async () => {
    let stopped = () => {};
    platform.ask.mockImplementation((ask: string) =>
      ask === "collisions"
        ? new Promise((resolve) => answers.push(resolve))
        : new Promise<void>((resolve) => {
            stopped = resolve;
          }),
    );
    check();
    await vi.advanceTimersByTimeAsync(200);
    useDesign.setState({ version: 2 });
    check();
    expect(asked("stop-collisions")).toBe(1);
    // It has ended before it is stopped.
    await answer();
    expect([stands(), asked("collisions")]).toEqual(["running", 1]);
    stopped();
    await vi.advanceTimersByTimeAsync(0);
    expect(asked("collisions")).toBe(2);
    await answer();
    expect([stands(), codes()]).toEqual(["done", ["meets_machine"]]);
  });

  it("says that it takes long, and is stopped by a person until they want it again", async () => {
    check();
    await vi.advanceTimersByTimeAsync(1900);
    expect(useCollisions.getState().long).toBe(false);
    await vi.advanceTimersByTimeAsync(200);
    expect(useCollisions.getState().long).toBe(true);
    stopCollisions();
    expect([stands(), asked("stop-collisions")]).toEqual(["stopped", 1]);
    await answer({ ...found, checked: false, stopped: true, contacts: [] });
    expect([stands(), useDesign.getState().collisions]).toEqual(["stopped", null]);
    lookForCollisions();
    expect(stands()).toBe("running");
  });

  it("says why it could not be made", async () => {
    platform.ask.mockRejectedValueOnce(new Error("No machine is chosen."));
    check();
    await vi.advanceTimersByTimeAsync(0);
    expect(useCollisions.getState()).toMatchObject({ stands: "failed", problem: "No machine is chosen." });
  });
});
