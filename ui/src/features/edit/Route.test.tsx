// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { designState } from "../../state/testing";
import { Route } from "./Route";

const at = place();

beforeEach(() => {
  const state = designState({ wires: 2, reversed: true });
  const nothing = { vertices: [], gone_vertices: [], edges: [], gone_edges: [], stencil: false, state };
  platform.ask.mockReset().mockResolvedValue(nothing);
  useDesign.setState({
    state,
    vertices: new Map([3, 5].map((id) => [id, { id, at: [id, 0, 0], support: false }])),
    edges: new Map(),
  });
});

const asked = () => platform.ask.mock.calls.filter(([name]) => name === "edit").map(([, { request }]) => request);

const wireOf = () => [...at.host.querySelectorAll("input")];

describe("the wire", () => {
  it.each([
    ["reversed", 0, { edit: "reversed", reversed: false }],
    ["closed", 1, { edit: "closed", closed: true }],
  ])("is %s by the choice of a person", async (_, index, request) => {
    at.show(<Route />);
    expect(wireOf().map(({ checked }) => checked)).toEqual([true, false, false]);
    await act(async () => wireOf()[index]?.click());
    expect(asked()).toEqual([request]);
  });

  it("is bent in as many pieces as a person allows", async () => {
    at.show(<Route />);
    const wires = wireOf()[2];
    expect(wires?.value).toBe("2");
    await act(async () => void wires?.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowUp", bubbles: true })));
    expect(asked()).toEqual([{ edit: "wires", wires: 3 }]);
  });

  it("says that more pieces save no edge that a person has doubled", () => {
    at.show(<Route />);
    expect(at.host.textContent).toContain("Fewer are used where more would not save doubled edges.");
    act(() => useDesign.setState({ state: designState({ wires: 2, doublings: [4] }) }));
    expect(at.host.textContent).toContain("Doubled edges stay doubled: clear them");
  });
});
