import type { ChosenStencil, SceneStencil, SceneSurface, Vec3 } from "../../scene/interface";
import { colourOf, type StencilView } from "../../state/parts/parts";

/** The stencils that have a surface to show. */
export function stencilsOf(
  stencils: readonly StencilView[],
  surfaces: ReadonlyMap<number, SceneSurface>,
): SceneStencil[] {
  return stencils.flatMap(({ id, look, surface: placed }) => {
    const surface = surfaces.get(id);
    if (!surface || !placed) return [];
    return [{ id, surface, matrix: placed.matrix, colour: colourOf(look), hidden: look.hidden ?? false }];
  });
}

/** The stencil that is chosen, with the box around it; null without one that can be seen. */
export function chosenOf(stencils: readonly StencilView[], chosen: number | null): ChosenStencil | null {
  const stencil = stencils.find(({ id }) => id === chosen);
  const placed = stencil?.surface;
  if (!placed || stencil.look.hidden) return null;
  const { matrix, middle_mm: middle, size_mm: size } = placed;
  const inDesign = (corner: Vec3): Vec3 => {
    const [x, y, z] = matrix.map(([a, b, c, by]) => a * corner[0] + b * corner[1] + c * corner[2] + by);
    return [x ?? 0, y ?? 0, z ?? 0];
  };
  const corner = (signs: number): Vec3 => {
    const side = (axis: 0 | 1 | 2) => middle[axis] + (signs & (1 << axis) ? 0.5 : -0.5) * size[axis];
    return inDesign([side(0), side(1), side(2)]);
  };
  // An edge of the box goes from a corner along each axis that it is on the low side of.
  const box = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((from) =>
    [1, 2, 4].filter((axis) => (from & axis) === 0).map((axis) => [corner(from), corner(from | axis)] as const),
  );
  return { id: stencil.id, middle: inDesign(middle), box };
}
