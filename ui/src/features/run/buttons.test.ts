import { describe, expect, it } from "vitest";
import { buttons, doingPhrase, phrase } from "./buttons";
import { machineState as state } from "../../state/testing";

const READY = { program: true, feasible: true };

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
    expect(buttons({ ...state("ready"), busy: true, question }, READY).jog).toBe("Answer the question first.");
    expect(buttons({ ...state("connected"), busy: true }, READY).home).toBe("Wait until the machine is done.");
    expect(buttons({ ...state("making"), busy: true }, READY).home).toBe("A wire is being made.");
    expect(doingPhrase({ ...state("ready"), doing: "reading", question })).toBe("waits for an answer");
    expect(doingPhrase(state("homing"))).toBe("homing");
  });

  it("leads from connected to home, arm, start", () => {
    expect(buttons(state("connected", "home", "arm", "disconnect"), READY)).toMatchObject({ next: "home", home: null, jog: "Home the machine first." });
    expect(buttons(state("ready", "home", "jog", "arm"), READY)).toMatchObject({ next: "arm", arm: null, start: "Arm a wire first." });
    expect(buttons(state("armed", "start", "disarm", "jog"), READY)).toMatchObject({ next: "start", start: null, disarm: null });
  });

  it("goes by what the operator says that it can be told, not by the phase", () => {
    expect(buttons(state("ready"), READY).home).not.toBeNull();
    expect(buttons(state("making"), READY).pause).toEqual({ order: "pause", why: "This machine cannot pause." });
  });

  it("arms nothing that cannot be made", () => {
    const ready = state("ready", "arm", "home");
    expect(buttons(ready, { program: false, feasible: false })).toMatchObject({ arm: "There is no program to make: see Check.", next: null });
    expect(buttons(ready, { program: true, feasible: false }).arm).toBe("The machine cannot make the design: see Check.");
  });

  it("has one button to pause and to go on", () => {
    expect(buttons(state("making", "pause"), READY)).toMatchObject({ pause: { order: "pause", why: null }, next: "pause" });
    expect(buttons(state("holding", "resume"), READY)).toMatchObject({ pause: { order: "resume", why: null }, next: "resume" });
  });
});

describe("phrase", () => {
  it("tells how the machine stands", () => {
    expect(phrase(null)).toBe("not connected");
    expect(phrase({ ...state("ready"), simulated: true })).toBe("simulated machine · homed");
    expect(phrase(state("connected"))).toBe("/dev/ttyACM0 · not homed");
    const wire = { wire: 0, made: 14, done_by: "machine" as const, sent: 16, of: 31, elapsed_s: 60, remaining_s: 80, job_hash: "", name: "House" };
    expect(phrase({ ...state("making"), wire })).toBe("making a wire · 14 of 31 made");
  });
});

describe("writing settings", () => {
  it("is possible where the machine says so, and says why where it is not", () => {
    expect(buttons(state("ready", "write-settings"), READY).writeSettings).toBeNull();
    expect(buttons(state("ready"), READY).writeSettings).toBe("This machine's settings cannot be written from here.");
    expect(buttons(state("making"), READY).writeSettings).toBe("A wire is being made.");
  });
});
