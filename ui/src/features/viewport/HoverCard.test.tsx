// @vitest-environment happy-dom
import { expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { useView } from "../../state/window/view";
import { HoverCard } from "./HoverCard";

const at = place();

it.each([
  [1, "Vertex 1 · 2 edges"],
  [2, "Vertex 2 · 1 edge · odd corner"],
])("calls a vertex with an odd number of edges what the findings call it: vertex %i", (id, title) => {
  const edge = (id: number, a: number, b: number) => [id, { id, a, b }] as const;
  useDesign.setState({
    vertices: new Map([0, 1, 2].map((id) => [id, { id, at: [id, 0, 0] as const, support: false }])),
    edges: new Map([edge(0, 0, 1), edge(1, 1, 2)]),
  });
  useView.setState({ hovered: { kind: "vertex", id, x: 0, y: 0 } });
  at.show(<HoverCard />);
  expect(at.host.querySelector("strong")?.textContent).toBe(title);
});
