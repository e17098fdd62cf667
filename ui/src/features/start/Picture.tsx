import { memo, useMemo } from "react";
import type { ExampleEntry } from "../../generated/responses";
import { project } from "./project";

/** From so many lines on they are drawn thinner. */
const DENSE = 80;

/** Lines as a small picture; what is far is faint. Says nothing by itself: what it shows is named beside it. */
export const Picture = memo(function Picture({
  lines,
  width,
  height,
}: {
  readonly lines: ExampleEntry["lines_mm"];
  readonly width: number;
  readonly height: number;
}) {
  const drawn = useMemo(() => project(lines, width, height), [lines, width, height]);
  return (
    <svg
      className={lines.length > DENSE ? "picture dense" : "picture"}
      viewBox={`0 0 ${width} ${height}`}
      aria-hidden="true"
      focusable="false"
    >
      {drawn.map(({ from, to, near }, index) => (
        <line
          // biome-ignore lint/suspicious/noArrayIndexKey: lines have no other name
          key={index}
          x1={from[0].toFixed(1)}
          y1={from[1].toFixed(1)}
          x2={to[0].toFixed(1)}
          y2={to[1].toFixed(1)}
          opacity={(0.35 + 0.65 * near).toFixed(2)}
        />
      ))}
    </svg>
  );
});
