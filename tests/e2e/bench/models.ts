import type { Place } from "../support/sight.ts";

/** Of both models, mm. */
const RADIUS = 150;
const RING = 60;

/** Rings of the wireframe, and vertices of each. */
const RINGS = 34;
const AROUND = 10;

function vertexOf(ring: number, k: number): Place {
  const turn = ((k + 0.5 * (ring % 2)) / AROUND) * 2 * Math.PI;
  return [RADIUS * Math.cos(turn), RADIUS * Math.sin(turn), RING * ring];
}

/** Places of the vertices of the column, by id. */
export const PLACES: readonly Place[] = Array.from({ length: RINGS * AROUND }, (_, id) =>
  vertexOf(Math.floor(id / AROUND), id % AROUND),
);

/** The column of 1000 edges of `benches/benches/pipeline.rs`, as OBJ in mm: one wire runs through all of it. */
export function column(): string {
  const edges: string[] = [];
  const number = (ring: number, k: number): number => ring * AROUND + (k % AROUND) + 1;
  for (let ring = 0; ring < RINGS; ring += 1) {
    for (let k = 0; k < AROUND; k += 1) {
      edges.push(`l ${number(ring, k)} ${number(ring, k + 1)}`);
      if (ring + 1 === RINGS) continue;
      const shift = ring % 2;
      edges.push(
        `l ${number(ring, k)} ${number(ring + 1, k + shift)}`,
        `l ${number(ring, k)} ${number(ring + 1, k + shift + AROUND - 1)}`,
      );
    }
  }
  return [...PLACES.map((place) => `v ${place.join(" ")}`), ...edges, ""].join("\n");
}

/** Quadrangles around and along the surface, two triangles each. */
const [U, V] = [200, 500];
export const TRIANGLES = 2 * U * V;

/** A tube with waves, on which the column would have been traced, as binary STL in mm. */
export function surface(): Buffer {
  const corner = (u: number, v: number): Place => {
    const [turn, height] = [((u % U) / U) * 2 * Math.PI, (v / V) * RING * (RINGS - 1)];
    const radius = RADIUS - 2 + 2 * Math.sin(turn * 9) * Math.sin(height / 25);
    return [radius * Math.cos(turn), radius * Math.sin(turn), height];
  };
  // 80 bytes of header, the count, and 50 bytes a triangle: its normal, which may be zero, and its corners.
  const file = Buffer.alloc(84 + 50 * TRIANGLES);
  file.writeUInt32LE(TRIANGLES, 80);
  let at = 84;
  const triangle = (...corners: readonly Place[]): void => {
    corners.flat().forEach((value, index) => file.writeFloatLE(value, at + 12 + 4 * index));
    at += 50;
  };
  for (let v = 0; v < V; v += 1) {
    for (let u = 0; u < U; u += 1) {
      const [a, b, c, d] = [corner(u, v), corner(u + 1, v), corner(u + 1, v + 1), corner(u, v + 1)];
      triangle(a, b, c);
      triangle(a, c, d);
    }
  }
  return file;
}
