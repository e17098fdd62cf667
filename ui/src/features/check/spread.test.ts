import { describe, expect, it } from "vitest";
import type { Prediction } from "../../generated/responses";
import { rising } from "../frame/ramp";
import { ballsOf, bends, byVertex, farthest, hottest, playedBallsOf, scatters, sources, widest } from "./spread";

const vertex = (vertex: number, mean_mm: number, radius_95_mm: number) => ({
  vertex,
  machine_mm: null,
  systematic_mm: 0,
  mean_mm,
  radius_95_mm,
});

const wire = (more: Partial<Prediction["wires"][number]>): Prediction["wires"][number] => ({
  vertices: [],
  gaps: [],
  worst_machine_mm: null,
  worst_systematic_mm: 0,
  worst_rounded_mm: 0,
  worst_mean_mm: 0,
  worst_radius_95_mm: 0,
  sources: [],
  steps: [],
  collisions: null,
  ...more,
});

/** A wire that comes back to its first vertex, and one that ends at it. */
const prediction: Prediction = {
  noise: "typical",
  runs: 100,
  wires: [
    wire({
      vertices: [vertex(0, 0, 0), vertex(1, 1, 2), vertex(0, 2, 4)],
      gaps: [{ vertex: 0, passes: 2, machine_mm: null, mean_mm: 2, radius_95_mm: 4 }],
      sources: [
        { source: "bend", rms_mm: 3 },
        { source: "feed", rms_mm: 1 },
      ],
      steps: [
        { step: 1, vertex: 1, feed_mm: 1, rotate_mm: 0, bend_mm: 3 },
        { step: 2, vertex: 0, feed_mm: 1, rotate_mm: 0, bend_mm: 0 },
      ],
    }),
    wire({
      vertices: [vertex(2, 0, 0), vertex(0, 1, 1)],
      gaps: [],
      sources: [
        { source: "bend", rms_mm: 0 },
        { source: "feed", rms_mm: 4 },
      ],
      steps: [{ step: 1, vertex: 0, feed_mm: 4, rotate_mm: 0, bend_mm: 5 }],
    }),
  ],
  tolerance: null,
};

describe("how far vertices scatter", () => {
  it("lists every vertex once, the worst first, with the gap of its passes", () => {
    expect(byVertex(prediction)).toEqual([
      { vertex: 0, mean: 2, radius: 4, gap: 4 },
      { vertex: 1, mean: 1, radius: 2, gap: null },
      { vertex: 2, mean: 0, radius: 0, gap: null },
    ]);
  });

  it("counts the pass of a vertex that scatters most", () => {
    expect(scatters(prediction)).toEqual(
      new Map([
        [0, { mean: 2, radius: 4 }],
        [1, { mean: 1, radius: 2 }],
        [2, { mean: 0, radius: 0 }],
      ]),
    );
    expect(hottest(prediction)).toBe(2);
  });

  it("is drawn as balls around the vertices that are there, and none where one is in place", () => {
    const vertices = new Map([
      [0, { id: 0, at: [0, 0, 0] as const, support: false }],
      [2, { id: 2, at: [9, 0, 0] as const, support: false }],
    ]);
    expect(ballsOf(prediction, vertices)).toEqual([{ at: [0, 0, 0], radius: 4, colour: rising(1) }]);
  });

  it("follows one wire in its order, with what it scatters at each pass and the wire up to there", () => {
    const vertices = new Map([
      [0, { id: 0, at: [0, 0, 0] as const, support: false }],
      [1, { id: 1, at: [30, 40, 0] as const, support: false }],
    ]);
    const [first, second, ...rest] = playedBallsOf(prediction, 0, vertices);
    expect(rest).toEqual([]);
    // The colour is that of the mean: half as hot as the vertex that is off by 2 mm on average.
    expect(first).toEqual({ at: [30, 40, 0], radius: 2, along: 50, colour: rising(0.5) });
    expect(second).toMatchObject({ at: [0, 0, 0], radius: 4, along: 100 });
    // Colours say the same of every wire.
    expect(second?.colour).toEqual(ballsOf(prediction, vertices)[0]?.colour);
    expect(playedBallsOf(prediction, 2, vertices)).toEqual([]);
  });

  it("names the vertex that is farthest off, and the one whose passes are farthest apart", () => {
    expect(farthest(prediction)).toEqual({ vertex: 0, mean: 2, radius: 4 });
    expect(widest(prediction)).toEqual({ vertex: 0, mean: 2, radius: 4 });
    expect(widest({ ...prediction, wires: [] })).toBeNull();
  });
});

describe("what errors come from", () => {
  it("takes the kinds of all wires together, by how many vertices each has", () => {
    const [first, second] = sources(prediction);
    expect([first?.source, second?.source]).toEqual(["feed", "bend"]);
    expect(first?.rms).toBeCloseTo(Math.sqrt((3 * 1 + 2 * 16) / 5));
    expect(second?.rms).toBeCloseTo(Math.sqrt((3 * 9) / 5));
  });

  it("names the bends that move the wires most, and no straight step", () => {
    expect(bends(prediction, 5)).toEqual([
      { vertex: 0, rms: 5 },
      { vertex: 1, rms: 3 },
    ]);
  });
});
