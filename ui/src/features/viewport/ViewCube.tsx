import { type PointerEvent, useRef, useState } from "react";
import { flyTo, run, useWhyNot, whyNot, whyNotFrom } from "../../state/window/commands";
import { keyOf } from "../../state/window/keys";
import { type Side, useView } from "../../state/window/view";
import { useViewAxes } from "../../state/window/view_axes";
import { facesOf, SIDE_NAMES, sideOf, type Zone, zoneName, zoneOf } from "./cube";
import "./view_cube.css";

/** CSS pixels: of the picture, and from the middle of the cube to a face, so that its corners stay within. */
const SIZE = 108;
const SCALE = 30;
/** Pixels that a press may tremble. */
const STILL = 4;
/** A cube that is as small turns as far as its face is dragged, the view by less. */
const FASTER = 4;

const label = (side: Side): string => zoneName(zoneOf(side));

const whyNotZone = (zone: Zone): string | null => {
  const side = sideOf(zone);
  return side ? whyNot(`view-${side}`) : whyNotFrom(zone);
};

function choose(zone: Zone): void {
  if (whyNotZone(zone)) return;
  const side = sideOf(zone);
  if (side) flyTo(side);
  else useView.getState().handle?.fly(zone);
}

/** For keyboards and screen readers: in sight while it has the focus, below the cube that may show that face from behind. */
function SideButton({ side }: { readonly side: Side }) {
  const name = useView((view) => view.viewName);
  const why = useWhyNot(`view-${side}`);
  const keys = keyOf(`view-${side}`);
  return (
    <button
      type="button"
      className="view-side"
      aria-pressed={name === label(side)}
      aria-disabled={why ? true : undefined}
      title={why ?? `${label(side)} (${keys})`}
      onClick={() => flyTo(side)}
    >
      <span className="view-key" aria-hidden="true">
        {keys}
      </span>
      {label(side)}
    </button>
  );
}

/** What the view looks at, as a cube: a click on a face, an edge or a corner looks from there, a drag turns it. */
function Cube() {
  const axes = useViewAxes((store) => store.axes);
  const name = useView((view) => view.viewName);
  // What may be chosen depends on them.
  useView(({ tool, plane, ownPlane, strand }) => `${tool} ${plane} ${ownPlane === null} ${strand}`);
  const [hovered, setHovered] = useState<string | null>(null);
  const pressed = useRef<{ x: number; y: number; zone: Zone; dragged: boolean } | null>(null);
  if (!axes) return null;
  const down = (event: PointerEvent<SVGElement>, zone: Zone) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    pressed.current = { x: event.clientX, y: event.clientY, zone, dragged: false };
  };
  const move = ({ clientX, clientY, buttons }: PointerEvent) => {
    // The face that holds the pointer is gone once it is seen from its edge: the button may be let go elsewhere.
    if (buttons === 0) pressed.current = null;
    const from = pressed.current;
    if (!from) return;
    const [dx, dy] = [clientX - from.x, clientY - from.y];
    if (!from.dragged && Math.hypot(dx, dy) <= STILL) return;
    pressed.current = { ...from, x: clientX, y: clientY, dragged: true };
    useView.getState().handle?.turn(dx * FASTER, dy * FASTER);
  };
  const up = () => {
    const from = pressed.current;
    pressed.current = null;
    if (from && !from.dragged) choose(from.zone);
  };
  return (
    <svg
      className="view-cube"
      viewBox={`${-SIZE / 2} ${-SIZE / 2} ${SIZE} ${SIZE}`}
      width={SIZE}
      height={SIZE}
      aria-hidden="true"
      onPointerMove={move}
      onPointerUp={up}
      onPointerCancel={() => (pressed.current = null)}
    >
      {facesOf(axes, SCALE).map(({ side, points, patches, transform, square }) => (
        <g key={side} className={label(side) === name ? "cube-face shown" : "cube-face"}>
          <polygon className="cube-ground" points={points} />
          {patches.map(({ zone, points: part }) => {
            const what = zoneName(zone);
            const why = whyNotZone(zone);
            const state = `${hovered === what ? " hovered" : ""}${why ? " off" : ""}`;
            return (
              <polygon
                key={what}
                className={`cube-zone${state}`}
                data-zone={what}
                points={part}
                onPointerEnter={() => setHovered(what)}
                onPointerLeave={() => setHovered(null)}
                onPointerDown={(event) => down(event, zone)}
              >
                <title>{why ?? what}</title>
              </polygon>
            );
          })}
          {square > 0.3 && (
            <text transform={transform} className={hovered === label(side) ? "hovered" : undefined}>
              {label(side)}
            </text>
          )}
        </g>
      ))}
    </svg>
  );
}

/** From where the view looks, and the ways to look from elsewhere. */
export function ViewCube() {
  const name = useView((view) => view.viewName);
  const free = name === "Parallel" ? name : "Perspective";
  return (
    <fieldset className="view-corner" aria-label="View">
      <Cube />
      {SIDE_NAMES.map((side) => (
        <SideButton key={side} side={side} />
      ))}
      <button
        type="button"
        className="view-button"
        aria-pressed={name === free}
        title="Perspective or parallel"
        onClick={() => run("view-perspective")}
      >
        <span className="view-key" aria-hidden="true">
          {keyOf("view-perspective")}
        </span>
        {free}
      </button>
      <button type="button" className="view-button" onClick={() => run("frame-all")} title="Frame everything (Home)">
        <span className="view-key" aria-hidden="true">
          {keyOf("frame")}
        </span>
        Frame
      </button>
    </fieldset>
  );
}
