/** What is left between readings and the fitted model, as points of a small plot: x what was commanded, y read less fitted. */

import type { KindReport } from "../../../generated/responses";

export interface ResidualPlot {
  readonly points: readonly { readonly x: number; readonly y: number; readonly key: string; readonly off: number }[];
  /** Where 0 is, px. */
  readonly zero: number;
  /** Half of the band in which two of three readings are, px. */
  readonly band: number;
  /** What the upper edge means, in the unit of the readings. */
  readonly most: number;
  /** What is commanded at both ends. */
  readonly ends: readonly [number, number];
}

/** px from the edges to the outermost points. */
const INSET = 10;

export function residualsOf({ values, scatter }: KindReport, width: number, height: number): ResidualPlot {
  const commanded = values.map((value) => value.commanded);
  const [low, high] = [Math.min(...commanded), Math.max(...commanded)];
  const off = values.map(({ read, fitted }) => read - fitted);
  const most = Math.max(...off.map(Math.abs), scatter, 1e-6);
  const zero = height / 2;
  const scale = (zero - INSET) / most;
  const across = high > low ? (width - 2 * INSET) / (high - low) : 0;
  return {
    points: values.map(({ commanded: at, line, reading }, index) => ({
      key: `${line} ${reading}`,
      off: off[index] ?? 0,
      x: across > 0 ? INSET + (at - low) * across : width / 2,
      y: zero - (off[index] ?? 0) * scale,
    })),
    zero,
    band: Math.min(zero, scatter * scale),
    most,
    ends: [low, high],
  };
}
