/** A frame as the view draws it: its lines with their colours, where it is worst, and what the legend says. */

import type { FrameShown } from "../../generated/responses";
import type { Colour, SceneLine, SceneStruts } from "../../scene/interface";
import { largest, movedOf, size } from "../../state/frame/figures";
import type { Coloured, FrameView } from "../../state/frame/shape";
import { diverging, rising, UNKNOWN } from "./ramp";

/** What the colours are of, and how far they reach. */
interface Legend {
  readonly coloured: Coloured;
  /** mm, a share of the yield strength, or N. */
  readonly most: number;
  /** A mode has no size of its own. */
  readonly relative: boolean;
  /** Struts whose figure is not known. */
  readonly unknown: number;
}

interface Drawn {
  readonly struts: SceneStruts;
  readonly legend: Legend;
}

/** What can be coloured: forces are those of what acts on the frame alone. */
const colouredIn = (view: FrameView, coloured: Coloured): Coloured =>
  view.kind === "loaded" ? coloured : "displacement";

export function drawnFrame(answer: FrameShown, view: FrameView, wanted: Coloured): Drawn | null {
  const moved = movedOf(answer, view);
  if (!moved) return null;
  const coloured = colouredIn(view, wanted);
  const members = answer.result.static?.members ?? [];
  const figures = members.map((member) => (coloured === "axial" ? member.axial_n : member.utilisation));
  const most =
    coloured === "displacement"
      ? largest(moved.by)
      : figures.reduce<number>((most, figure) => Math.max(most, Math.abs(figure ?? 0)), 0);
  const share = (figure: number) => (most > 0 ? figure / most : 0);
  let worst: SceneStruts["worst"] = null;
  let farthest = -1;
  const see = (line: number, point: number, figure: number) => {
    if (figure <= farthest) return;
    farthest = figure;
    const at = moved.at[line]?.[point];
    worst = at ? { at, by: moved.by[line]?.[point] ?? null } : null;
  };
  const lines = moved.at.map((at, line): SceneLine => {
    const by = moved.by[line] ?? [];
    let colours: Colour[];
    if (coloured === "displacement") {
      colours = by.map((way, point) => {
        see(line, point, size(way));
        return rising(share(size(way)));
      });
    } else {
      const figure = figures[line] ?? null;
      if (figure !== null) see(line, at.length >> 1, Math.abs(figure));
      const ramp = coloured === "axial" ? diverging : rising;
      colours = [figure === null ? UNKNOWN : ramp(share(figure))];
    }
    return { at, by, colours };
  });
  const unknown = coloured === "displacement" ? 0 : figures.filter((figure) => figure === null).length;
  const relative = view.kind === "mode";
  return {
    struts: { lines, ghost: true, worst: relative || most === 0 ? null : worst, head: null },
    legend: { coloured, most, relative, unknown },
  };
}
