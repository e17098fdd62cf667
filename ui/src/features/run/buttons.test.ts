import { describe, expect, it } from "vitest";
import type { Because, MachineState, OrderName, Phase } from "../../state/machine/operator";
import { refused, machineState as state } from "../../state/testing";
import { buttons, doingPhrase, phrase } from "./buttons";

/** A machine that says why it cannot be told one order. */
const because = (phase: Phase, order: OrderName, why: Because, ...can: OrderName[]): MachineState => ({
  ...state(phase, ...can),
  cannot: refused("busy", ...can).map((each) => (each.order === order ? { order, because: why } : each)),
});

const READY = { machine: "wirebend-kit", program: true, feasible: true, file: null };

describe("buttons", () => {
  it("lets nothing but connecting be done without a machine, and says why", () => {
    const { next, ...rest } = buttons(null, READY);
    expect(next).toBe("connect");
    expect(rest.home).toBe("Connect a machine first.");
    expect(rest.start).toBe("Connect a machine first.");
    expect(rest.jog).toBe("Connect a machine first.");
  });

  it("waits for an answer, and for the end of an order", () => {
    const question = { id: 1, kind: "arm" as const, lines: [], question: "", doubt: null, head: null };
    const asked = { ...state("ready"), busy: true, question, cannot: refused("question-open") };
    expect(buttons(asked, READY).jog).toBe("Answer the question first.");
    expect(buttons({ ...state("connected"), busy: true }, READY).home).toBe("Wait until the machine is done.");
    expect(buttons(because("making", "home", "wire-under-way"), READY).home).toBe("A wire is being bent.");
    expect(doingPhrase({ ...state("ready"), doing: "reading", question })).toBe("waits for an answer");
    expect(doingPhrase(state("homing"))).toBe("homing");
    expect(doingPhrase({ ...state("making"), doing: "bending the wire" })).toBe("bending the wire");
    expect(doingPhrase({ ...state("holding"), doing: "bending the wire" })).toBe("paused");
  });

  it("leads from connected to home, arm, start", () => {
    expect(buttons(because("connected", "jog", "not-homed", "home", "arm", "disconnect"), READY)).toMatchObject({
      next: "home",
      home: null,
      jog: "Home the machine first.",
    });
    expect(buttons(because("ready", "start", "no-wire-armed", "home", "jog", "arm"), READY)).toMatchObject({
      next: "arm",
      arm: null,
      start: "Arm the machine first.",
    });
    expect(buttons(state("armed", "start", "disarm", "jog"), READY)).toMatchObject({
      next: "start",
      start: null,
      disarm: null,
    });
  });

  it("arms no other machine than that of the wire", () => {
    const ready = state("ready", "arm", "dry-run", "home");
    const other = "The wire is for another machine than the one that is connected.";
    expect(buttons(ready, { ...READY, machine: "grbl-bender" })).toMatchObject({
      arm: other,
      dryRun: other,
      next: null,
      home: null,
    });
    expect(buttons(ready, { ...READY, machine: null })).toMatchObject({ arm: null, next: "arm" });
  });

  it("goes by what the machine's state says that it can do, and why not, in every phase", () => {
    const phases = ["connected", "homing", "ready", "armed", "making", "failed", "closed"] as const;
    for (const phase of phases) {
      expect(buttons(state(phase, "home"), READY).home).toBeNull();
      expect(buttons(because(phase, "home", "wire-armed"), READY).home).toBe(
        "The machine is armed: start or disarm it first.",
      );
    }
    expect(buttons(because("making", "pause", "unable"), READY).pause).toEqual({
      order: "pause",
      why: "This machine cannot pause.",
    });
    expect(buttons(because("ready", "home", "unable"), READY).home).toBe("This machine cannot do that.");
  });

  it("homes a machine that failed where the machine's state says so alone", () => {
    expect(buttons(state("failed", "home", "disconnect"), READY)).toMatchObject({ next: "connect", home: null });
    expect(buttons(because("failed", "home", "failed", "disconnect"), READY).home).toBe(
      "The machine failed: connect it again.",
    );
  });

  it("arms nothing that cannot be made", () => {
    const ready = state("ready", "arm", "home");
    expect(buttons(ready, { ...READY, program: false, feasible: false })).toMatchObject({
      arm: "There is no program to run: see Check.",
      next: null,
    });
    expect(buttons(ready, { ...READY, feasible: false }).arm).toBe("The machine cannot make the design: see Check.");
  });

  it("has one button to pause and to resume", () => {
    expect(buttons(state("making", "pause"), READY)).toMatchObject({
      pause: { order: "pause", why: null },
      next: "pause",
    });
    expect(buttons(state("holding", "resume"), READY)).toMatchObject({
      pause: { order: "resume", why: null },
      next: "resume",
    });
  });
});

describe("phrase", () => {
  it("says how the machine stands", () => {
    expect(phrase(null)).toBe("not connected");
    expect(phrase({ ...state("ready"), simulated: true })).toBe("simulated machine · homed");
    expect(phrase(state("connected"))).toBe("/dev/ttyACM0 · not homed");
    const wire = {
      wire: 0,
      piece: null,
      stock_left_mm: null,
      made: 14,
      done_by: "machine" as const,
      sent: 16,
      of: 31,
      in_step: 0,
      elapsed_s: 60,
      remaining_s: 80,
      job_hash: "",
      name: "House",
    };
    expect(phrase({ ...state("making"), wire })).toBe("bending · 14 of 31 done");
    expect(phrase({ ...state("holding"), wire })).toBe("paused · 14 of 31 done");
  });
});

describe("writing settings", () => {
  it("is possible where the machine says so, and says why where it is not", () => {
    expect(buttons(state("ready", "write-settings"), READY).writeSettings).toBeNull();
    expect(buttons(because("ready", "write-settings", "unable"), READY).writeSettings).toBe(
      "This machine's settings cannot be written from here.",
    );
    expect(buttons(because("making", "write-settings", "wire-under-way"), READY).writeSettings).toBe(
      "A wire is being bent.",
    );
  });
});
