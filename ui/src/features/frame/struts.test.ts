import { describe, expect, it } from "vitest";
import { frameShown } from "../../state/frame/testing";
import { diverging, rising, UNKNOWN } from "./ramp";
import { drawnFrame } from "./struts";
import { endsOf, enlarged, phraseOf } from "./words";

const drawn = (...given: Parameters<typeof drawnFrame>) => {
  const found = drawnFrame(...given);
  if (!found) throw new Error("nothing is drawn");
  return found;
};

describe("a frame in the view", () => {
  it("is coloured from point to point by how far it moves, and marks where it moves most", () => {
    const { struts, legend } = drawn(frameShown(), { kind: "loaded" }, "displacement");
    expect(struts.lines[0]?.colours).toEqual([rising(0), rising(1)]);
    expect(struts.worst).toEqual({ at: [0, 0, 100], by: [0, 0, -0.5] });
    expect(legend).toMatchObject({ most: 0.5, relative: false });
  });

  it("is grey where no force is, and shows compression and tension on one scale", () => {
    const { struts, legend } = drawn(frameShown(), { kind: "loaded" }, "axial");
    expect(struts.lines.map(({ colours }) => colours)).toEqual([[diverging(-1)], [diverging(0.5)]]);
    expect(legend.most).toBe(4);
    expect(endsOf("axial", 4, "mm")).toEqual(["−4 N", "0", "4 N"]);
  });

  it("says of how many struts the utilisation is not known", () => {
    const shown = frameShown();
    for (const member of shown.result.static?.members ?? []) if (member.edge === 0) member.utilisation = null;
    const { struts, legend } = drawn(shown, { kind: "loaded" }, "utilisation");
    expect(struts.lines[0]?.colours).toEqual([UNKNOWN]);
    expect(legend).toMatchObject({ most: 0.2, unknown: 1 });
  });

  it("has no largest place and no forces of a mode", () => {
    const { struts, legend } = drawn(frameShown(), { kind: "mode", mode: 1 }, "axial");
    expect(struts.worst).toBeNull();
    expect(legend).toMatchObject({ coloured: "displacement", relative: true });
  });

  it("is nothing where joints were not closed", () => {
    expect(drawnFrame(frameShown(), { kind: "made" }, "displacement")).toBeNull();
  });
});

describe("words of a frame", () => {
  it("names true scale", () => {
    expect([enlarged(1), enlarged(500), enlarged(0.05)]).toEqual(["true scale", "500 × enlarged", "0.05 × true scale"]);
  });

  it("says in the header how far it moves and how it vibrates", () => {
    expect(phraseOf(frameShown(), "mm")).toBe("moves 0.5 mm · 12.3 Hz");
  });

  it.each([
    ["frame_unsupported", 0, "floats · 12.3 Hz"],
    ["frame_unsupported", 2, "partly floats · 12.3 Hz"],
    ["frame_mechanism", 2, "does not stand · 12.3 Hz"],
    ["strut_overstressed", 2, "yields · 12.3 Hz"],
    ["edge_too_short", 2, "does not hold · 12.3 Hz"],
  ] as const)("says in the header why a frame does not hold: %s with %s supports", (code, supports, phrase) => {
    const { shapes, result } = frameShown();
    const diagnostics = [{ code, severity: "error" as const, message: "", help: "" }];
    const frame = { ...result.frame, supports };
    expect(phraseOf({ shapes, result: { ...result, frame, static: null, holds: false, diagnostics } }, "mm")).toBe(
      phrase,
    );
  });
});
