import { describe, expect, it } from "vitest";
import { asText, type ConsoleLine, filtered, withLines } from "./console";

const AT = new Date(2026, 0, 2, 14, 3, 7, 50).getTime();
const line = (text: string, toMachine = false) => ({ text, toMachine, at: AT });
const lines: readonly ConsoleLine[] = withLines([], [line("G1 X10", true), line("ok"), line("<Idle|MPos:0,0,0>")]);

describe("withLines", () => {
  it("numbers lines on, and lets go of the oldest", () => {
    const more = withLines(lines, [line("ok"), line("ok")], 4);
    expect(more.map(({ id }) => id)).toEqual([2, 3, 4, 5]);
    expect(withLines(more, [line("x")], 4).at(-1)?.id).toBe(6);
  });
});

describe("filtered", () => {
  it("wants every word, in any case", () => {
    expect(filtered(lines, "idle MPOS").map(({ id }) => id)).toEqual([3]);
    expect(filtered(lines, "idle x10")).toEqual([]);
    expect(filtered(lines, "  ")).toBe(lines);
  });
});

describe("asText", () => {
  it("says when a line went, and which way", () => {
    expect(asText(lines.slice(0, 2))).toBe("14:03:07.050 > G1 X10\n14:03:07.050 < ok");
  });
});
