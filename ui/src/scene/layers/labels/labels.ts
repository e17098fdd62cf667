/** Short texts at places of the design, as elements over the picture. Those that would lie on another are left out until there is room. */

import { css, type Theme } from "../../drawing/theme";
import type { SceneLabel, Vec3, Verdict } from "../../interface";
import type { Projection } from "../../view/projection";

interface Placed {
  readonly label: SceneLabel;
  readonly element: HTMLElement;
}

/** CSS pixels, of the font below; measuring each would lay out the page anew. */
const LETTER = 6.4;
const HEIGHT = 19;
const OFF = 12;
/** From a line to a label beside it, and from a place to the middle of one that lies towards another. */
const BESIDE = 11;
const TOWARDS = 34;

/** Errors are placed first, so that they are not the ones left out. */
const ORDER: Readonly<Record<Verdict, number>> = { error: 0, warning: 1, fine: 2 };
const SIGNS: Readonly<Record<Verdict, string>> = { error: "▲ ", warning: "◆ ", fine: "" };

export class Labels {
  private placed: readonly Placed[] = [];

  constructor(
    private readonly overlay: HTMLElement,
    private theme: Theme,
  ) {}

  /** Elements that are there are used again: while something is dragged their texts change with every frame. */
  show(labels: readonly SceneLabel[]): void {
    const sorted = labels.toSorted((a, b) => rank(a) - rank(b));
    const before = this.placed;
    for (const { element } of before.slice(sorted.length)) element.remove();
    this.placed = sorted.map((label, index) => {
      const element = before[index]?.element ?? this.element();
      const text = textOf(label);
      if (element.textContent !== text) element.textContent = text;
      if (before[index]?.label.verdict !== label.verdict) this.colour(element, label);
      return { label, element };
    });
    this.overlay.append(...this.placed.slice(before.length).map(({ element }) => element));
  }

  /** With every frame; none at all where they do not belong to what is seen. */
  place(projection: Projection, shown: boolean): void {
    const taken: { x: number; y: number; width: number }[] = [];
    for (const { label, element } of this.placed) {
      const seen = projection.seen(label.at);
      const width = textOf(label).length * LETTER + 15;
      const [x, y] = corner(label, projection, width);
      const within =
        shown &&
        (label.first || fits(label, projection, width)) &&
        projection.sees(seen) &&
        seen.x > -width &&
        seen.y > 0 &&
        seen.x < projection.width &&
        seen.y < projection.height;
      const free =
        within &&
        !taken.some((other) => Math.abs(other.y - y) < HEIGHT && x < other.x + other.width && other.x < x + width);
      element.style.visibility = free ? "visible" : "hidden";
      if (!free) continue;
      taken.push({ x, y, width });
      element.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
    }
  }

  paint(theme: Theme): void {
    this.theme = theme;
    for (const { label, element } of this.placed) this.colour(element, label);
  }

  private element(): HTMLElement {
    const element = document.createElement("div");
    Object.assign(element.style, {
      position: "absolute",
      left: "0",
      top: "0",
      padding: "0 6px",
      borderLeft: "3px solid transparent",
      borderRadius: "4px",
      font: `11.5px/${HEIGHT}px system-ui, sans-serif`,
      fontVariantNumeric: "tabular-nums",
      whiteSpace: "nowrap",
      visibility: "hidden",
    });
    this.colour(element, { verdict: null });
    return element;
  }

  private colour(element: HTMLElement, { verdict }: Pick<SceneLabel, "verdict">): void {
    element.style.color = this.theme.text;
    element.style.background = this.theme.textBack;
    element.style.borderLeftColor = verdict ? css(this.theme[verdict]) : "transparent";
  }
}

const rank = ({ verdict, first }: SceneLabel): number => (first ? -1 : verdict ? ORDER[verdict] : 3);

const textOf = ({ text, verdict }: SceneLabel): string => (verdict ? SIGNS[verdict] : "") + text;

/** Whether a label beside a line is no longer than the line is seen to be. */
function fits({ beside }: SceneLabel, projection: Projection, width: number): boolean {
  if (!beside) return true;
  const [a, b] = [projection.seen(beside[0]), projection.seen(beside[1])];
  return Math.hypot(b.x - a.x, b.y - a.y) >= width;
}

/** The upper left corner, CSS pixels. */
function corner({ at, beside, towards }: SceneLabel, projection: Projection, width: number): [number, number] {
  const seen = projection.seen(at);
  const amid = (x: number, y: number): [number, number] => [seen.x + x - width / 2, seen.y + y - HEIGHT / 2];
  const way = (from: Vec3, to: Vec3): [number, number] | null => {
    const [a, b] = [projection.seen(from), projection.seen(to)];
    const size = Math.hypot(b.x - a.x, b.y - a.y);
    return size > 1e-6 ? [(b.x - a.x) / size, (b.y - a.y) / size] : null;
  };
  if (beside) {
    // Below the line, or to the left of one that is upright: the arrows of the gizmo go up and to the right.
    const [x, y] = way(...beside) ?? [1, 0];
    const below = Math.abs(x) > 0.05 ? Math.sign(x) : Math.sign(y);
    const off = BESIDE + (Math.abs(y) * width + Math.abs(x) * HEIGHT) / 2;
    return amid(-y * below * off, x * below * off);
  }
  const aside = towards && way(at, towards);
  if (aside) return amid(aside[0] * (TOWARDS + (Math.abs(aside[0]) * width) / 3), aside[1] * TOWARDS);
  return [seen.x + OFF, seen.y - OFF - HEIGHT / 2];
}
