import type { SceneDesign } from "../../scene/interface";

interface Part {
  readonly vertices: number[];
  readonly edges: number[];
}

/** Everything that does not hang together with the largest part: of several parts with as many edges the first stays. */
export function smallerParts({ edges }: Pick<SceneDesign, "edges">): Part {
  const parts = new Map<number, Part>();
  for (const { id, a, b } of edges.values()) {
    const [one, other] = [parts.get(a), parts.get(b)];
    const part = one ?? other ?? { vertices: [], edges: [] };
    const joins = one && other && one !== other ? other : null;
    part.vertices.push(...[a, b].filter((vertex) => !parts.has(vertex)), ...(joins?.vertices ?? []));
    part.edges.push(id, ...(joins?.edges ?? []));
    for (const vertex of [a, b, ...(joins?.vertices ?? [])]) parts.set(vertex, part);
  }
  const each = [...new Set(parts.values())];
  const largest = each.reduce<Part | null>(
    (most, part) => (most && most.edges.length >= part.edges.length ? most : part),
    null,
  );
  const rest = each.filter((part) => part !== largest);
  return { vertices: rest.flatMap(({ vertices }) => vertices), edges: rest.flatMap((part) => part.edges) };
}
