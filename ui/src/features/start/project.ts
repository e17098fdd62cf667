import type { Vec3 } from "../../scene/interface";

/** A line of a small picture: x to the right, y down, and how near it is, from 0 (far) to 1. */
export interface PictureLine {
  readonly from: readonly [number, number];
  readonly to: readonly [number, number];
  readonly near: number;
}

/** Where the eye is: turned about z, then raised, degrees. Everything is seen from the front right, a little from above. */
const YAW = 32;
const PITCH = 24;

/** Lines in mm, z up, as a picture of `width` by `height` with a margin; far ones first. Looked at from the front where nothing is deep. */
export function project(
  lines: readonly (readonly [Vec3, Vec3])[],
  width: number,
  height: number,
  margin = 8,
): PictureLine[] {
  const turn = (deg: number) => [Math.cos((deg * Math.PI) / 180), Math.sin((deg * Math.PI) / 180)] as const;
  const [cy, sy] = turn(YAW);
  const [cp, sp] = turn(PITCH);
  const seen = ([x, y, z]: Vec3): [number, number, number] => {
    const right = x * cy + y * sy;
    const away = -x * sy + y * cy;
    return [right, -(z * cp + away * sp), -(away * cp - z * sp)];
  };
  const all = lines.map(([a, b]) => [seen(a), seen(b)] as const);
  const points = all.flat();
  const range = (k: 0 | 1 | 2) => {
    let [low, high] = [Infinity, -Infinity];
    for (const point of points) {
      low = Math.min(low, point[k]);
      high = Math.max(high, point[k]);
    }
    return { low, size: high - low };
  };
  if (points.length === 0) return [];
  const [x, y, depth] = [range(0), range(1), range(2)];
  const scale = Math.min((width - 2 * margin) / Math.max(x.size, 1e-9), (height - 2 * margin) / Math.max(y.size, 1e-9));
  const place = ([px, py]: readonly [number, number, number]): [number, number] => [
    width / 2 + (px - x.low - x.size / 2) * scale,
    height / 2 + (py - y.low - y.size / 2) * scale,
  ];
  const near = (point: readonly [number, number, number]) => (depth.size > 0 ? (point[2] - depth.low) / depth.size : 1);
  return all
    .map(([a, b]) => ({ from: place(a), to: place(b), near: (near(a) + near(b)) / 2 }))
    .sort((a, b) => a.near - b.near);
}
