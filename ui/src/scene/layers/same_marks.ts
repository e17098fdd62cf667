import type { SceneMarks } from "../interface";

/** Whether marks look the same. */
export function areSame(a: SceneMarks, b: SceneMarks): boolean {
  const verdicts = (a: SceneMarks["vertices"], b: SceneMarks["vertices"]): boolean =>
    a.size === b.size && [...a].every(([id, verdict]) => b.get(id) === verdict);
  const ids = (a: SceneMarks["odd"], b: SceneMarks["odd"]): boolean =>
    a.size === b.size && [...a].every((id) => b.has(id));
  return (
    a.checked === b.checked &&
    a.start?.vertex === b.start?.vertex &&
    a.start?.towards === b.start?.towards &&
    verdicts(a.vertices, b.vertices) &&
    verdicts(a.edges, b.edges) &&
    ids(a.odd, b.odd) &&
    ids(a.doubled, b.doubled) &&
    a.colours.size === b.colours.size &&
    [...a.colours].every(([id, colour]) => b.colours.get(id) === colour)
  );
}
