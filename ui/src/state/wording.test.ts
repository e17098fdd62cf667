import { describe, expect, it } from "vitest";
import { worded } from "./wording";

describe("worded", () => {
  it.each([
    ["exists", "/there/house.txt exists already: name another file, or replace it with --force", "/there/house.txt exists already"],
    ["driver-not-trusted", "/opt/libx.so is a driver that did not come with this program (SHA-256 12ab); if you trust its author, accept it with `wirebend driver trust /opt/libx.so`", "SHA-256 12ab"],
    ["settings-differ", "the machine is not set as the profile of 'kit' says, and wires would come out wrong: feed is 3, not 4; write them with `wirebend machine-settings --machine kit --port p --write`, or make wires all the same with --accept-settings", "feed is 3, not 4"],
    ["unfinished", "wire 1 of this job was begun on Monday and is not over: 3 of 5 steps are made; go on with `wirebend run x --resume`, or give it up with `wirebend run x --abandon`", "3 of 5 steps are made"],
    ["moves-of-another", "up.wbmoves was recorded on 'a', not on 'b'; to replay it all the same, say --machine b", "recorded on 'a', not on 'b'"],
    ["no-port", "say with --port where the machine is; there are: sim", "port"],
    ["contradiction", "the machine counts 4 steps, the journal 3. With `run x --resume=made:N`, `run x --resume=not-made:N` or `run x --resume=part:N:MM:DEGREES` of the first step N that it is unknown of, the machine is stopped, and the answer is taken", "The machine counts 4 steps, the journal 3"],
    ["only-stencil", "bunny.stl holds a surface and no lines: import it with --face-edges to take the edges of its faces, or trace a wireframe on it", "bunny.stl holds a surface"],
    ["value", "--scale is 0: a number above 0", "Scale is 0: a number above 0"],
  ])("keeps the fact of %s, and names no option or command", (code, message, fact) => {
    const said = worded({ code, message });
    expect(said).toContain(fact);
    expect(said).not.toMatch(/--[a-z]|`|wirebend run|wirebend driver/);
  });

  it("leaves other messages as they are, but for a capital where no name of a file begins them", () => {
    expect(worded({ code: "read-number", message: "line 3 of a.obj: 'x' is no number" })).toBe("Line 3 of a.obj: 'x' is no number");
    expect(worded({ code: "read-number", message: "a.obj, line 3: 'x' is no number" })).toBe("a.obj, line 3: 'x' is no number");
    expect(worded({ code: "read-io", message: "cube: it cannot be read" })).toBe("cube: it cannot be read");
    expect(worded({ code: "constructor", message: "/x is damaged" })).toBe("/x is damaged");
  });
});
