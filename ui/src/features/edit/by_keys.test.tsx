// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { select, useSelection } from "../../state/design/selection";
import { AddVertex } from "./AddVertex";
import { VertexTable } from "./VertexTable";

const at = place();

beforeEach(() => {
  platform.ask.mockReset().mockReturnValue(new Promise(() => {}));
  useDesign.setState({
    vertices: new Map([3, 5].map((id) => [id, { id, at: [id, 0, 0], support: false }])),
    edges: new Map(),
  });
});

const press = (on: Element | undefined | null, init: KeyboardEventInit) =>
  act(() => void on?.dispatchEvent(new KeyboardEvent("keydown", { bubbles: true, cancelable: true, ...init })));

describe("without a pointer", () => {
  it("a vertex is added where its figures say, with the one that was typed last", async () => {
    at.show(<AddVertex />);
    const fields = [...at.host.querySelectorAll("input")];
    for (const [k, text] of ["12.5", "-3", "40"].entries()) {
      const field = fields[k];
      if (!field) throw new Error("no field");
      act(() => {
        // React listens to the setter of the prototype.
        Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, text);
        field.dispatchEvent(new Event("input", { bubbles: true }));
        if (k < 2) field.dispatchEvent(new FocusEvent("focusout", { bubbles: true }));
      });
    }
    press(fields[2], { key: "Enter" });
    await act(async () => {});
    const edits = platform.ask.mock.calls.filter(([name]) => name === "edit").map(([, { request }]) => request);
    expect(edits).toEqual([
      {
        edit: "several",
        label: "add vertex",
        edits: [{ edit: "paste", vertices: [{ at_mm: [12.5, -3, 40], support: false }], edges: [] }],
      },
    ]);
  });

  it("several vertices are selected in the table, in the order in which they are to be connected", () => {
    at.show(<VertexTable />);
    const rows = [...at.host.querySelectorAll(".vertex-id")];
    act(() => select([5]));
    press(rows[0], { key: "Enter", ctrlKey: true });
    expect([...useSelection.getState().vertices]).toEqual([5, 3]);
    press(rows[1], { key: "Enter", shiftKey: true });
    expect([...useSelection.getState().vertices]).toEqual([3]);
  });
});
