import { describe, expect, it } from "vitest";
import type { PortEntry } from "../../generated/responses";
import type { Unfinished, WireRun, WireState } from "../../state/machine/operator";
import {
  endedPhrase,
  guess,
  machinePhrase,
  movePhrase,
  portPhrase,
  progressPhrase,
  simulatedPhrase,
  unfinishedPhrase,
} from "./phrases";

const port = (name: string, given: Partial<PortEntry> = {}): PortEntry => ({
  name,
  description: "",
  usb: null,
  drivers: ["wirebend-kit"],
  likely_for: [],
  simulated: false,
  ...given,
});
const SIM = port("sim", { simulated: true, description: "simulated machine, in real time" });
const UNO = port("/dev/ttyACM0", { description: "Arduino Uno", likely_for: ["wirebend-kit"] });

it("says of the machine that is connected what it says of itself, and its name once: there is room for a line", () => {
  const of = (identity: string | null, simulated = false) => ({ simulated, port: "/dev/ttyACM0", identity });
  expect(machinePhrase("WireBend-kit", of("WireBend-kit, firmware 1.13", true))).toBe(
    "WireBend-kit · simulated · firmware 1.13",
  );
  expect(machinePhrase("Mine", of("WireBend-kit, firmware 1.13"))).toBe(
    "Mine · /dev/ttyACM0 · WireBend-kit, firmware 1.13",
  );
  expect(machinePhrase("Mine", of(null))).toBe("Mine · /dev/ttyACM0");
});

describe("a simulated machine", () => {
  it("is named by what it has that its profile does not", () => {
    const name = (id: string) => `“${id}”`;
    expect(simulatedPhrase({}, name)).toBeNull();
    expect(simulatedPhrase({ machine: "kit" }, name)).toBe("simulated with the bend head of “kit”");
    expect(simulatedPhrase({ machine: "kit", material: "steel" }, name)).toBe(
      "simulated with the bend head of “kit” and the wire steel",
    );
  });
});

describe("ports", () => {
  it("says what is there, and which is probably meant", () => {
    expect(portPhrase(UNO)).toBe("/dev/ttyACM0 · Arduino Uno · probably this one");
    expect(portPhrase(SIM)).toBe("sim · simulated machine, in real time");
    expect(portPhrase(port("COM3"))).toBe("COM3");
  });

  it("guesses a likely port, else the simulated machine, and never a port of which nothing is known", () => {
    expect(guess([port("/dev/ttyS0"), SIM, UNO])).toBe("/dev/ttyACM0");
    expect(guess([port("/dev/ttyS0"), SIM])).toBe("sim");
    expect(guess([port("/dev/ttyS0")])).toBeNull();
  });
});

describe("wires", () => {
  const unfinished = (made: number, in_doubt: Unfinished["in_doubt"] = null): Unfinished => ({
    id: "1",
    job_hash: "",
    name: "House",
    wire: 0,
    piece: null,
    port: "sim",
    started: "",
    made,
    of: 31,
    in_doubt,
    resumable: true,
  });

  it("says how far one is", () => {
    const wire: WireState = {
      wire: 0,
      piece: null,
      stock_left_mm: null,
      made: 14,
      done_by: "machine",
      sent: 16,
      of: 31,
      in_step: 0,
      elapsed_s: 130,
      remaining_s: 65,
      job_hash: "",
      name: "House",
    };
    expect(progressPhrase(wire)).toBe("14 of 31 steps done · 2:10, 1:05 left");
    expect(progressPhrase({ ...wire, piece: { number: 2, of: 5 } })).toMatch(/^Piece 2 of 5 · 14 of 31/);
    // It is not known whether they are done.
    expect(progressPhrase({ ...wire, done_by: "clock" })).toBe("14 of 31 steps by the clock · 2:10, 1:05 left");
    expect(unfinishedPhrase(unfinished(14))).toBe("Step 14 of 31 is done.");
    expect(unfinishedPhrase(unfinished(14, [15, 15]))).toBe(
      "Step 14 of 31 is done. Step 15 was sent: before the wire resumes, the machine or you say what became of it.",
    );
    expect(unfinishedPhrase(unfinished(0, [1, 3]))).toBe(
      "No step of 31 is done. Steps 1 to 3 were sent: before the wire resumes, the machine or you say what became of them.",
    );
    expect(unfinishedPhrase({ ...unfinished(0), resumable: false })).toMatch(/cannot be resumed/);
  });

  const run: WireRun = {
    id: "1",
    resume: null,
    stock_mm: 700,
    stopped_by: null,
    standstill: null,
    wire: 0,
    piece: null,
    outcome: "made",
    made: 31,
    done_by: "machine",
    steps: 31,
    in_doubt: null,
    stopped_in: null,
    elapsed_s: 192,
    problem: null,
    deviations_mm: [0.02, 0.08],
  };

  it("says what became of one", () => {
    expect(endedPhrase(run, "mm")).toEqual({
      tone: "fine",
      what: "The wire is finished, in 3:12",
      sub: "Worst vertex 0.08 mm from the design.",
    });
    expect(endedPhrase({ ...run, deviations_mm: null }, "mm").sub).toBeNull();
    const of = { of: "House", several: false };
    for (const outcome of ["made", "made-before", "sent", "stopped", "failed", "abandoned"] as const)
      expect(endedPhrase({ ...run, outcome }, "mm", of).what).toMatch(/^The wire of House(:| is| was) [a-z]/);
    expect(endedPhrase({ ...run, outcome: "stopped", standstill: "not-confirmed" }, "mm", of).what).toMatch(
      /^The wire of House: not confirmed/,
    );
    const ofHouse = endedPhrase(run, "mm", { of: "House", several: true });
    expect(ofHouse.what).toMatch(/^Wire 1 of House is finished/);
    expect(ofHouse.sub).toMatch(/from its design\.$/);
    expect(endedPhrase(run, "mm", { of: "", several: false }).what).toMatch(
      /^The wire of a design without a name is finished/,
    );
    expect(endedPhrase({ ...run, outcome: "stopped", made: 14 }, "mm").what).toBe("Stopped after step 14 of 31");
    expect(endedPhrase({ ...run, outcome: "stopped", standstill: "confirmed", made: 14 }, "mm").what).toBe(
      "Stopped after step 14 of 31",
    );
    expect(endedPhrase({ ...run, outcome: "sent", done_by: "clock" }, "mm")).toMatchObject({
      what: "All 31 steps are sent",
      sub: "The machine does not report whether it ran them: look at the wire.",
    });
    // A user who reads "stopped" lets go of the power switch.
    expect(endedPhrase({ ...run, outcome: "stopped", standstill: "not-confirmed", made: 14 }, "mm")).toMatchObject({
      tone: "error",
      what: "Not confirmed that the machine stands, after step 14 of 31",
      sub: "Cut the power of the machine, then look at it and at the wire.",
    });
    expect(
      endedPhrase({ ...run, outcome: "failed", made: 3, problem: { code: "line", message: "The line is cut." } }, "mm"),
    ).toMatchObject({ tone: "error", sub: "The line is cut." });
  });
});

describe("movePhrase", () => {
  it("says moves with their units", () => {
    expect(movePhrase({ move: "feed", mm: -10 }, "mm")).toBe("Feed −10.0 mm");
    expect(movePhrase({ move: "rotate", deg: 90 }, "mm")).toBe("Rotate 90.0°");
    expect(movePhrase({ move: "home" }, "mm")).toBe("Home");
  });
});
