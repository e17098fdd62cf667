/** Elements over the picture: the box of a selection, what a grab does in numbers, the scale of the grid. */

import { css, type Theme } from "../drawing/theme";
import type { Box } from "../picking/box_select";

export class Overlay {
  /** Over the canvas, without taking its pointer. */
  readonly element = document.createElement("div");
  private readonly frame = document.createElement("div");
  private readonly number = document.createElement("div");
  private readonly scale = document.createElement("div");

  constructor(private readonly canvas: HTMLCanvasElement) {
    Object.assign(this.element.style, { position: "absolute", inset: "0", overflow: "hidden", pointerEvents: "none" });
    Object.assign(this.frame.style, { position: "absolute", boxSizing: "border-box", display: "none" });
    const text = {
      position: "absolute",
      left: "16px",
      font: "12px/20px system-ui, sans-serif",
      fontVariantNumeric: "tabular-nums",
      whiteSpace: "pre",
    };
    Object.assign(this.number.style, text, {
      // Above the help at the pointer.
      bottom: "44px",
      padding: "2px 10px",
      borderRadius: "6px",
      display: "none",
    });
    // Two lines of it end below what is above the help.
    Object.assign(this.scale.style, text, { bottom: "12px", lineHeight: "16px", opacity: "0.62" });
    // The picture's own scale says nothing to a user who cannot see the picture.
    this.scale.ariaHidden = "true";
    this.element.append(this.frame, this.number, this.scale);
  }

  box(box: Box | null, touches: boolean, theme: Theme): void {
    this.frame.style.display = box ? "block" : "none";
    if (!box) return;
    const colour = css(theme.acted);
    Object.assign(this.frame.style, {
      left: `${Math.min(box.x0, box.x1)}px`,
      top: `${Math.min(box.y0, box.y1)}px`,
      width: `${Math.abs(box.x1 - box.x0)}px`,
      height: `${Math.abs(box.y1 - box.y0)}px`,
      border: `1px ${touches ? "dashed" : "solid"} ${colour}`,
      background: `color-mix(in srgb, ${colour} 10%, transparent)`,
    });
  }

  readout(text: string | null): void {
    if (this.number.textContent === (text ?? "")) return;
    this.number.style.display = text === null ? "none" : "block";
    this.number.textContent = text;
  }

  grid(text: string): void {
    if (this.scale.textContent !== text) this.scale.textContent = text;
  }

  cursor(name: string): void {
    this.canvas.style.cursor = name;
  }

  paint(theme: Theme): void {
    for (const text of [this.number, this.scale]) text.style.color = theme.text;
    this.number.style.background = theme.textBack;
  }
}
