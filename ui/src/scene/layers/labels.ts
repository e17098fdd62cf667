/** Short texts at places of the design, as elements over the picture. Those that would lie on another are left out until there is room. */

import { css, type Theme } from "../drawing/theme";
import type { SceneLabel, Verdict } from "../interface";
import type { Projection } from "../view/projection";

interface Placed {
  readonly label: SceneLabel;
  readonly element: HTMLElement;
}

/** CSS pixels, of the font below; measuring each would lay out the page anew. */
const LETTER = 6.4;
const HEIGHT = 19;
const OFF = 12;

/** Errors are placed first, so that they are not the ones left out. */
const ORDER: Readonly<Record<Verdict, number>> = { error: 0, warning: 1, fine: 2 };
const SIGNS: Readonly<Record<Verdict, string>> = { error: "▲ ", warning: "◆ ", fine: "" };

export class Labels {
  private placed: readonly Placed[] = [];

  constructor(
    private readonly overlay: HTMLElement,
    private theme: Theme,
  ) {}

  show(labels: readonly SceneLabel[]): void {
    for (const { element } of this.placed) element.remove();
    const sorted = labels.toSorted((a, b) => rank(a) - rank(b));
    this.placed = sorted.map((label) => ({ label, element: this.element(label) }));
    this.overlay.append(...this.placed.map(({ element }) => element));
  }

  /** With every frame; none at all where they do not belong to what is seen. */
  place(projection: Projection, shown: boolean): void {
    const taken: { x: number; y: number; width: number }[] = [];
    for (const { label, element } of this.placed) {
      const seen = projection.seen(label.at);
      const width = textOf(label).length * LETTER + 15;
      const [x, y] = [seen.x + OFF, seen.y - OFF - HEIGHT / 2];
      const within =
        shown &&
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

  private element(label: SceneLabel): HTMLElement {
    const element = document.createElement("div");
    element.textContent = textOf(label);
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
    this.colour(element, label);
    return element;
  }

  private colour(element: HTMLElement, { verdict }: SceneLabel): void {
    element.style.color = this.theme.text;
    element.style.background = this.theme.textBack;
    element.style.borderLeftColor = verdict ? css(this.theme[verdict]) : "transparent";
  }
}

const rank = ({ verdict }: SceneLabel): number => (verdict ? ORDER[verdict] : 3);

const textOf = ({ text, verdict }: SceneLabel): string => (verdict ? SIGNS[verdict] : "") + text;
