// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from "vitest";
import type { SceneDesign, SceneListener, Vec3 } from "../interface";
import { NOTHING_SELECTED } from "../layers/drawn_design";
import { Overlay } from "../layers/overlay";
import { Stage } from "../stage";
import { designOf, given, MM } from "../testing";
import { looking } from "../view/orbit";
import { ARC } from "./gizmo_parts";
import { SelectTool } from "./select_tool";

const AT: Vec3[] = [
  [0, 0, 0],
  [30, 0, 0],
  [60, 0, 0],
];
const ENDS = [
  [0, 1],
  [1, 2],
] as const;

const listener = {
  dropped: vi.fn(),
  turned: vi.fn(),
  dragging: vi.fn(),
  dragCancelled: vi.fn(),
  stencilMoved: vi.fn(async () => {}),
  stencilTurned: vi.fn(async () => {}),
  hovered: vi.fn(),
  selected: vi.fn(),
  menu: vi.fn(),
};
let stage: Stage;
let tool: SelectTool;

beforeEach(() => {
  for (const heard of Object.values(listener)) heard.mockReset();
  const overlay = new Overlay(document.createElement("canvas"));
  stage = new Stage(overlay.element, MM, () => {});
  [stage.camera.width, stage.camera.height] = [800, 600];
  tool = new SelectTool(stage, listener as unknown as SceneListener, overlay);
  give(designOf(AT, ENDS));
  stage.select({ vertices: new Set([1]), edges: new Set(), lines: new Set() });
  tool.startGrab();
});

function give(design: SceneDesign): void {
  stage.setDesign(design);
  tool.designChanged();
}

const press = (key: string, rest: Partial<KeyboardEventInit> = {}): boolean =>
  tool.key(new KeyboardEvent("keydown", { key, ...rest }));
const place = (): number[] => [...(stage.design.place(1) ?? [])];

describe("while something is moved", () => {
  it.each(["Delete", "m", "c", "s", "e", "a", "Home", "?"])(
    "%s is not handed on: it would change what is in the hand",
    (key) => {
      expect(press(key)).toBe(true);
      expect(tool.grab).not.toBeNull();
    },
  );

  it.each(["z", "x", "s"])("Ctrl and %s neither lock an axis nor are handed on", (key) => {
    expect(press(key, { ctrlKey: true })).toBe(true);
    expect(tool.grab?.axis).toBeNull();
  });

  it("its own keys still count: along z, by 12 mm", () => {
    for (const key of ["z", "1", "2", "Enter"]) expect(press(key)).toBe(true);
    expect(listener.dropped).toHaveBeenCalledWith([{ vertex: 1, at: [30, 0, 12] }], [], [0, 0, 12]);
  });

  it("takes no key when nothing is in the hand", () => {
    tool.cancel();
    expect(press("Delete")).toBe(false);
    expect(press("z", { ctrlKey: true })).toBe(false);
  });

  it("it stays in the hand when something else of the design changes", () => {
    for (const key of ["z", "5"]) press(key);
    give(designOf([...AT.slice(0, 2), [70, 0, 0]], ENDS));
    expect(tool.grab).not.toBeNull();
    expect(place()).toEqual([30, 0, 5]);
  });

  it.each([
    ["is elsewhere", designOf([given(AT[0]), [31, 0, 0], given(AT[2])], ENDS), [31, 0, 0]],
    ["is gone", designOf([given(AT[0])], []), []],
  ])("it is let go when it %s", (_, design, at) => {
    for (const key of ["z", "5"]) press(key);
    give(design);
    expect(tool.grab).toBeNull();
    expect(listener.dragCancelled).toHaveBeenCalledOnce();
    expect(listener.dropped).not.toHaveBeenCalled();
    expect(place()).toEqual(at);
  });
});

describe("a right click", () => {
  const at = (id: number) => {
    const { x, y } = stage.projection.seen(given(stage.design.place(id) ?? undefined));
    return { x, y, shift: false, ctrl: false, touch: false };
  };

  it("gives up what is in the hand, and asks for nothing else", () => {
    tool.context(at(1));
    expect([tool.grab, listener.menu.mock.calls.length]).toEqual([null, 0]);
  });

  it("selects what it is on, and leaves a selection alone that has it", () => {
    tool.cancel();
    tool.context(at(2));
    expect([...stage.selected.selection.vertices]).toEqual([2]);
    stage.select({ vertices: new Set([0, 2]), edges: new Set(), lines: new Set() });
    tool.context(at(0));
    expect([...stage.selected.selection.vertices]).toEqual([0, 2]);
    expect(listener.menu).toHaveBeenCalledTimes(2);
  });
});

describe("an arc of the gizmo", () => {
  const place = (id: number): number[] => (stage.design.place(id) ?? []).map((mm) => Math.round(mm * 1e6) / 1e6 + 0);
  /** A place beside the middle, from above, as it is seen. */
  const beside = (x: number, y: number) => {
    const [cx, cy, cz] = given(stage.turnsAt);
    const pixel = stage.projection.pixel([cx, cy, cz]);
    const { x: left, y: down } = stage.projection.seen([cx + x * pixel, cy + y * pixel, cz]);
    return { x: left, y: down, shift: false, ctrl: false, touch: false };
  };
  const diagonal = ARC.radius * Math.SQRT1_2;

  beforeEach(() => {
    tool.cancel();
    for (const heard of Object.values(listener)) heard.mockReset();
    stage.camera.orbit = looking(stage.camera.orbit, "top");
    stage.viewMoved();
    stage.select({ vertices: new Set([0, 1]), edges: new Set(), lines: new Set() });
  });

  it("turns the selection about its middle, and tells how far when it is let go", () => {
    tool.press(beside(diagonal, diagonal));
    tool.drag(beside(-diagonal, diagonal));
    expect([place(0), place(1), place(2)]).toEqual([
      [15, -15, 0],
      [15, 15, 0],
      [60, 0, 0],
    ]);
    tool.release(beside(-diagonal, diagonal), true);
    expect(listener.turned).toHaveBeenCalledExactlyOnceWith([0, 1], [], "z", [15, 0, 0], 90);
    expect(listener.dropped).not.toHaveBeenCalled();
  });

  it("turns by a typed angle, about another axis too, and back with Escape", () => {
    tool.press(beside(diagonal, diagonal));
    tool.drag(beside(-diagonal, diagonal));
    press("y");
    expect([place(0), place(1)]).toEqual([
      [0, 0, 0],
      [30, 0, 0],
    ]);
    for (const key of "90") press(key);
    expect([place(0), place(1)]).toEqual([
      [15, 0, 15],
      [15, 0, -15],
    ]);
    press("Escape");
    expect([place(0), place(1)]).toEqual([
      [0, 0, 0],
      [30, 0, 0],
    ]);
    expect(listener.turned).not.toHaveBeenCalled();
  });

  it("ends with Enter, also while the button is held", () => {
    tool.press(beside(diagonal, diagonal));
    tool.drag(beside(-diagonal, diagonal));
    for (const key of ["3", "0", "Enter"]) press(key);
    tool.drag(beside(-diagonal, -diagonal));
    tool.release(beside(-diagonal, -diagonal), true);
    expect(listener.turned).toHaveBeenCalledExactlyOnceWith([0, 1], [], "z", [15, 0, 0], 30);
  });

  it("makes no edit of a whole turn", () => {
    tool.press(beside(diagonal, diagonal));
    tool.drag(beside(-diagonal, diagonal));
    for (const key of ["3", "6", "0"]) press(key);
    tool.release(beside(-diagonal, diagonal), true);
    expect(listener.turned).not.toHaveBeenCalled();
    expect([place(0), place(1)]).toEqual([
      [0, 0, 0],
      [30, 0, 0],
    ]);
  });

  it("leaves a vertex that lies on it to a click", () => {
    const [cx, cy] = given(stage.turnsAt);
    const pixel = stage.projection.pixel([cx, cy, 0]);
    give(designOf([...AT, [cx + diagonal * pixel, cy + diagonal * pixel, 0]], ENDS));
    tool.press(beside(diagonal, diagonal));
    tool.release(beside(diagonal, diagonal), false);
    expect([...stage.selected.selection.vertices]).toEqual([3]);
  });

  it("is not there for a single vertex, which it would not move", () => {
    stage.select({ vertices: new Set([1]), edges: new Set(), lines: new Set() });
    expect(stage.turnsAt).toBeNull();
  });

  it("turns the chosen stencil where nothing is selected, and shows it where it lies once that is so", async () => {
    const box: [Vec3, Vec3][] = [
      [
        [0, 0, 0],
        [40, 0, 0],
      ],
    ];
    let isSo = (): void => {};
    listener.stencilTurned.mockReturnValue(new Promise((resolve) => (isSo = resolve)));
    stage.select({ vertices: new Set(), edges: new Set(), lines: new Set() });
    stage.chooseStencil({ id: 7, middle: [20, 10, 0], box });
    const held = vi.spyOn(stage, "holdStencil");
    tool.press(beside(diagonal, diagonal));
    tool.drag(beside(-diagonal, diagonal));
    const end = held.mock.lastCall?.[0]?.([40, 0, 0]).map((mm) => Math.round(mm * 1e6) / 1e6);
    expect(end).toEqual([30, 30, 0]);
    tool.release(beside(-diagonal, diagonal), true);
    expect(listener.stencilTurned).toHaveBeenCalledExactlyOnceWith(7, "z", 90);
    expect(listener.turned).not.toHaveBeenCalled();
    expect([place(0), place(1)]).toEqual([
      [0, 0, 0],
      [30, 0, 0],
    ]);
    expect(held.mock.lastCall).not.toEqual([null]);
    isSo();
    await vi.waitFor(() => expect(held.mock.lastCall).toEqual([null]));
  });
});

describe("construction lines", () => {
  /** Above the vertices, and one that crosses it. */
  const LINES = [
    [
      [0, 0, 40],
      [60, 0, 40],
    ],
    [
      [50, 0, 30],
      [50, 0, 80],
    ],
  ] as const;
  const at = (place: Vec3) => ({ ...stage.projection.seen(place), shift: false, ctrl: false, touch: false });
  const shown = (owner: number) => stage.construction.endsOf({ ...NOTHING_SELECTED, lines: new Set([owner]) });

  beforeEach(() => {
    tool.cancel();
    for (const heard of Object.values(listener)) heard.mockReset();
    stage.camera.orbit = looking(stage.camera.orbit, "front");
    stage.viewMoved();
    stage.setConstruction(LINES);
    stage.select(NOTHING_SELECTED);
  });

  const click = (place: Vec3, rest = {}) => {
    tool.press({ ...at(place), ...rest });
    tool.release({ ...at(place), ...rest }, false);
  };

  it("are chosen by a click, and with Shift beside what is selected", () => {
    click([20, 0, 40]);
    expect(listener.selected).toHaveBeenLastCalledWith({ ...NOTHING_SELECTED, lines: new Set([0]) });
    click([50, 0, 70], { shift: true });
    click([30, 0, 0], { shift: true });
    expect(stage.selected.selection).toEqual({
      vertices: new Set([1]),
      edges: new Set(),
      lines: new Set([0, 1]),
    });
  });

  it("are told when the pointer is on one", () => {
    tool.hover(at([20, 0, 40]));
    expect(listener.hovered).toHaveBeenLastCalledWith(expect.objectContaining({ kind: "line", id: 0 }));
  });

  it("go along with vertices by a typed distance, and are told together", () => {
    stage.select({ vertices: new Set([2]), edges: new Set(), lines: new Set([1]) });
    tool.startGrab();
    for (const key of ["z", "1", "2"]) press(key);
    expect(shown(1)).toEqual([
      [50, 0, 42],
      [50, 0, 92],
    ]);
    press("Enter");
    expect(listener.dropped).toHaveBeenCalledWith([{ vertex: 2, at: [60, 0, 12] }], [1], [0, 0, 12]);
    // They stay there until the design has them.
    expect(shown(1)[0]).toEqual([50, 0, 42]);
    stage.setConstruction(LINES);
    expect(shown(1)[0]).toEqual([50, 0, 30]);
  });

  it("alone are moved and turned without asking for checks of the wire", () => {
    stage.select({ ...NOTHING_SELECTED, lines: new Set([0]) });
    tool.startGrab();
    for (const key of ["x", "5", "Enter"]) press(key);
    expect(listener.dropped).toHaveBeenCalledWith([], [0], [5, 0, 0]);
    expect(listener.dragging).not.toHaveBeenCalled();
    expect(stage.turnsAt).toEqual([35, 0, 40]);
  });

  it("are let go where the list is another one", () => {
    stage.select({ ...NOTHING_SELECTED, lines: new Set([1]) });
    tool.startGrab();
    for (const key of ["x", "5"]) press(key);
    stage.setConstruction([LINES[1]]);
    tool.linesChanged();
    expect([tool.grab, listener.dropped.mock.calls.length]).toEqual([null, 0]);
  });
});
