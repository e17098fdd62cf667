import type { Tool } from "../../scene/interface";
import { useByHand } from "../../state/machine/by_hand";
import { usePlayback } from "../../state/program/program";
import { useView } from "../../state/window/view";
import "./viewport.css";

/** What the left button does with each tool. */
const CLICKS: Readonly<Record<Tool, string>> = {
  select: "Select: click, or drag a box",
  trace: "Trace: click for each corner, Esc ends",
  draw: "Draw: click for each corner, Esc ends",
  measure: "Measure: click two things, Esc ends",
};

/** What the pointer does in the view, in a quiet line at its foot. */
export function PointerHint() {
  const tool = useView((view) => view.tool);
  const played = usePlayback(({ played }) => played !== null);
  const byHand = useByHand(({ played }) => played !== null);
  const parts = [
    ...(played || byHand ? [] : [CLICKS[tool]]),
    "Orbit: right or middle button",
    "Pan: Shift and middle button",
    "Zoom: wheel",
  ];
  return <p className="pointer-hint">{parts.join("  ·  ")}</p>;
}
