import { useMemo } from "react";
import type { Shape } from "../../../generated/responses";
import { pictureOf } from "./picture";

const COLOURS: Readonly<Record<Shape["part"], string>> = {
  frame: "var(--machine-frame)",
  head: "var(--machine-head)",
  peg: "var(--machine-peg)",
};

/** A machine drawn from its bodies; the same that the view shows. */
export function MachinePicture({ shapes, name }: { readonly shapes: readonly Shape[] | null; readonly name: string }) {
  const picture = useMemo(() => (shapes ? pictureOf(shapes) : null), [shapes]);
  if (!picture) return <span className="machine-picture" aria-hidden="true" />;
  const [x, y, width, height] = picture.box;
  const margin = Math.max(width, height) * 0.03;
  return (
    <svg
      className="machine-picture"
      viewBox={`${x - margin} ${y - margin} ${width + 2 * margin} ${height + 2 * margin}`}
      role="img"
      aria-label={`Picture of ${name}`}
    >
      {picture.faces.map(({ points, part, light }, index) => {
        // Less light is more black; the line hides the seam between two faces of the same plane.
        const colour = `color-mix(in srgb, ${COLOURS[part]}, black ${Math.round((1 - light) * 70)}%)`;
        return (
          <polygon
            // biome-ignore lint/suspicious/noArrayIndexKey: the faces of a body have no other name
            key={index}
            points={points.map(([px, py]) => `${px.toFixed(1)},${py.toFixed(1)}`).join(" ")}
            style={{ fill: colour, stroke: colour }}
            vectorEffect="non-scaling-stroke"
          />
        );
      })}
    </svg>
  );
}
