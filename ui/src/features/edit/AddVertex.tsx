import { useState } from "react";
import type { Vec3 } from "../../scene/interface";
import { Button } from "../../shared/Button";
import { useWhyNot } from "../../state/commands";
import { edit, useDesign } from "../../state/design";
import { select } from "../../state/selection";
import { PlaceFields } from "./Position";

/** Adds a vertex without an edge, and selects it. */
async function add(at: Vec3): Promise<void> {
  const { vertices } = useDesign.getState();
  const vertex = { edit: "paste" as const, vertices: [{ at_mm: [...at] as [number, number, number], support: false }], edges: [] };
  const change = await edit({ edit: "several", label: "add vertex", edits: [vertex] });
  if (change) select(change.vertices.filter(({ id }) => !vertices.has(id)).map(({ id }) => id));
}

/** A vertex where its figures say, without a pointer: Enter in a field adds it. */
export function AddVertex() {
  const [at, setAt] = useState<Vec3>([0, 0, 0]);
  const why = useWhyNot("paste");
  return (
    <div className="stack" role="group" aria-label="Add vertex">
      <PlaceFields at={at} change={setAt} label="New vertex" onEnter={(entered) => why === null && void add(entered)} />
      <div className="row">
        <Button className="grow" why={why} onClick={() => void add(at)}>
          Add vertex
        </Button>
      </div>
    </div>
  );
}
