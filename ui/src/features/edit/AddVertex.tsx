import { useState } from "react";
import type { Vec3 } from "../../scene/interface";
import { Button } from "../../shared/controls/Button";
import { edit, useDesign } from "../../state/design/design";
import { select } from "../../state/design/selection";
import { useWhyNot } from "../../state/window/commands";
import { PlaceFields } from "./Position";

/** Adds a vertex without an edge, and selects it. */
async function add(at: Vec3): Promise<void> {
  const { vertices } = useDesign.getState();
  const vertex = {
    edit: "paste" as const,
    vertices: [{ at_mm: [...at] as [number, number, number], support: false }],
    edges: [],
  };
  const change = await edit({ edit: "several", label: "add vertex", edits: [vertex] });
  if (change) select(change.vertices.filter(({ id }) => !vertices.has(id)).map(({ id }) => id));
}

/** A vertex where its figures say, without a pointer: Enter in a field adds it. */
export function AddVertex() {
  const [at, setAt] = useState<Vec3>([0, 0, 0]);
  const why = useWhyNot("paste");
  return (
    <fieldset className="stack" aria-label="Add vertex">
      <PlaceFields at={at} change={setAt} label="New vertex" onEnter={(entered) => why === null && void add(entered)} />
      <div className="row">
        <Button className="grow" why={why} onClick={() => void add(at)}>
          Add vertex
        </Button>
      </div>
    </fieldset>
  );
}
