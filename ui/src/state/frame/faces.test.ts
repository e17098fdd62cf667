import { describe, expect, it } from "vitest";
import { facesAsked, facesStillThere, whyNoFace, withFace, withoutFace } from "./faces";

describe("faces of selected vertices", () => {
  it("are taken in the order of their ids, and asked so", () => {
    const faces = withFace(withFace(null, [3, 1, 0, 2]), [7, 4, 6, 5]);
    expect(facesAsked(faces)).toEqual({
      vertices: [
        [0, 1, 2, 3],
        [4, 5, 6, 7],
      ],
    });
    expect(facesAsked({ file: "/there/flat.json" })).toEqual({ input: { file: "/there/flat.json" } });
    expect(facesAsked(null)).toBeNull();
  });

  it("take four vertices, each face once, and none beside a file", () => {
    const faces = withFace(null, [0, 1, 2, 3]);
    expect(whyNoFace(null, [0, 1, 2])).toMatch(/4 or more/);
    expect(whyNoFace(faces, [3, 2, 1, 0])).toBe("This face is in the list.");
    expect(whyNoFace(faces, [3, 2, 1, 4])).toBeNull();
    expect(whyNoFace({ file: "flat.json" }, [0, 1, 2, 3])).toMatch(/file/);
  });

  it("are gone with a vertex of theirs, and with the last of them all vertices count", () => {
    const faces = withFace(withFace(null, [0, 1, 2, 3]), [4, 5, 6, 7]);
    const vertices = new Map([0, 1, 2, 3, 5, 6, 7].map((id) => [id, { id, at: [0, 0, 0] as const, support: false }]));
    const left = facesStillThere(faces, { vertices });
    expect(left).toEqual({ vertices: [[0, 1, 2, 3]] });
    expect(facesStillThere(left, { vertices })).toBe(left);
    const [face] = left && "vertices" in left ? left.vertices : [];
    expect(left && face && withoutFace(left, face)).toBeNull();
    expect(facesStillThere(left, { vertices: new Map<number, never>() })).toBeNull();
  });
});
