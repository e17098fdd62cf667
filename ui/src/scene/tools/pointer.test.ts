// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";
import { Camera } from "../view/camera";
import { type Place, Pointer } from "./pointer";

const tool = {
  hover: vi.fn(),
  press: vi.fn(),
  drag: vi.fn(),
  release: vi.fn(),
  double: vi.fn(),
  context: vi.fn(),
  abort: vi.fn(),
};
let canvas: HTMLCanvasElement;
let pointer: Pointer;

beforeEach(() => {
  Object.values(tool).forEach((told) => told.mockReset());
  canvas = document.createElement("canvas");
  pointer = new Pointer(canvas, new Camera(), () => tool, vi.fn(), vi.fn());
});

function send(name: string, x: number, button = 0): void {
  // The canvas lies 100 pixels from the left.
  const event = new PointerEvent(name, { button, clientX: x + 100, cancelable: true });
  Object.defineProperties(event, { offsetX: { value: x }, offsetY: { value: 0 } });
  canvas.dispatchEvent(event);
}

/** Where it was dragged to, in order. */
const dragged = (): number[] => tool.drag.mock.calls.map(([at]) => (at as Place).x);

it("follows the first move of a frame at once, and the last one with the frame", () => {
  send("pointerdown", 0);
  send("pointermove", 10);
  expect(dragged()).toEqual([10]);
  send("pointermove", 11);
  send("pointermove", 12);
  expect(dragged()).toEqual([10]);
  pointer.work();
  expect(dragged()).toEqual([10, 12]);
  send("pointermove", 13);
  expect(dragged()).toEqual([10, 12, 13]);
});

it("drags by the earlier word of a move where there is one, and hovers without it", () => {
  send("pointerrawupdate", 5);
  pointer.work();
  expect(tool.hover).not.toHaveBeenCalled();
  send("pointerdown", 0);
  send("pointermove", 10);
  pointer.work();
  send("pointerrawupdate", 20);
  expect(dragged()).toEqual([10, 20]);
  // Reported once more with the frame.
  send("pointermove", 20);
  pointer.work();
  expect(dragged()).toEqual([10, 20]);
});

it("hovers once a frame", () => {
  send("pointermove", 1);
  send("pointermove", 2);
  expect(tool.hover).not.toHaveBeenCalled();
  pointer.work();
  expect(tool.hover.mock.calls.map(([at]) => (at as Place).x)).toEqual([2]);
});

it("ends a drag where the last move was, although no frame came between", () => {
  send("pointerdown", 0);
  send("pointermove", 10);
  send("pointermove", 30);
  send("pointerup", 30);
  expect(dragged()).toEqual([10, 30]);
  expect(tool.release).toHaveBeenCalledWith(expect.objectContaining({ x: 30 }), true);
});

it("asks for the menu by a right click that did not turn the view, and by the key for it", () => {
  const asked = (): number[] => tool.context.mock.calls.map(([at]) => (at as Place).x);
  send("pointerdown", 5, 2);
  send("contextmenu", 5, 2);
  expect(asked()).toEqual([]);
  send("pointerup", 5, 2);
  expect(asked()).toEqual([5]);
  send("pointerdown", 5, 2);
  send("pointermove", 60, 2);
  send("pointerup", 60, 2);
  expect(asked()).toEqual([5]);
  send("contextmenu", 0, 0);
  expect(tool.context).toHaveBeenCalledTimes(2);
});
