import type { Tool } from "../../scene/interface";
import { useFrame } from "../../state/frame/frame";
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
  plane: "Plane: click three points, Esc ends",
};

/** What a click that selects does while supports of a frame are picked. */
const PICKS = "Supports: click vertices, Esc ends";

/** The same of the tools that draw, while they draw construction lines. */
const CONSTRUCTS: Readonly<Partial<Record<Tool, string>>> = {
  trace: "Construction line: click for each end, Esc ends",
  draw: "Construction line: click for each end, Esc ends",
};

/** How the view is turned, moved and brought nearer, whatever the left button does. */
const MOVES = ["Orbit: right or middle button", "Pan: Shift and middle button", "Zoom: wheel"];

/** What the pointer does in the view, in a quiet line at its foot; in two, and parted between the clauses, where one is too long. */
export function PointerHint() {
  const tool = useView((view) => view.tool);
  const constructing = useView((view) => view.constructing);
  const picking = useFrame((frame) => frame.picking);
  const played = usePlayback(({ played }) => played !== null);
  const byHand = useByHand(({ played }) => played !== null);
  return (
    <p className="pointer-hint">
      {!played && !byHand && (
        <span className="pointer-hint-tool">
          {picking && tool === "select" ? PICKS : ((constructing ? CONSTRUCTS[tool] : undefined) ?? CLICKS[tool])}
        </span>
      )}
      {MOVES.map((move) => (
        <span key={move}>{move}</span>
      ))}
    </p>
  );
}
