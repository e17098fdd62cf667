import { useEffect, useRef, useState } from "react";
import type { BodiesListener, BodiesView, EditedMachine } from "../../scene/bodies_view";
import type { Vec3 } from "../../scene/interface";
import { lengthFormat } from "../../shared/figures/format";
import { shownTheme, systemTheme } from "../../state/window/theme";
import { useUi } from "../../state/window/ui";
import { useUnits } from "../../state/window/units";
import "./viewport.css";

const SIDES = [
  ["front", "Front"],
  ["right", "Right"],
  ["top", "Top"],
  ["perspective", "Perspective"],
] as const;

/** A machine whose bodies are edited, in three dimensions. Bodies are named by their place in the list. */
export function BodiesPicture({
  machine,
  chosen,
  editable,
  onChoose,
  onDrag,
  onDrop,
  onCancel,
}: {
  readonly machine: EditedMachine;
  readonly chosen: number | null;
  readonly editable: boolean;
  readonly onChoose: (body: number | null) => void;
  readonly onDrag: (body: number, at: Vec3) => void;
  readonly onDrop: (body: number, at: Vec3) => void;
  readonly onCancel: () => void;
}) {
  const host = useRef<HTMLDivElement>(null);
  const [view, setView] = useState<BodiesView | null>(null);
  const [name, setName] = useState("Perspective");
  const [wrong, setWrong] = useState<string | null>(null);
  // The scene is made once, and reports to whoever is there now.
  const hears = useRef({ onChoose, onDrag, onDrop, onCancel });
  hears.current = { onChoose, onDrag, onDrop, onCancel };
  useEffect(() => {
    let made: BodiesView | null = null;
    let gone = false;
    const listener: BodiesListener = {
      chosen: (body) => hears.current.onChoose(body),
      dragging: (body, at) => hears.current.onDrag(body, at),
      dropped: (body, at) => hears.current.onDrop(body, at),
      dragCancelled: () => hears.current.onCancel(),
      viewChanged: setName,
    };
    void import("../../scene/bodies_view").then(({ BodiesView: View }) => {
      if (gone || !host.current) return;
      try {
        made = new View(host.current, listener, {
          lengths: lengthFormat(useUnits.getState().unit),
          label: "View of the machine. Arrows turn it, G moves the chosen body, then X, Y or Z and a number.",
        });
        setView(made);
      } catch (error) {
        setWrong(error instanceof Error ? error.message : String(error));
      }
    });
    return () => {
      gone = true;
      made?.dispose();
    };
  }, []);
  const theme = useUi((ui) => ui.theme);
  useEffect(() => {
    const paint = () => view?.setTheme(shownTheme(theme));
    paint();
    const system = systemTheme();
    system.addEventListener("change", paint);
    return () => system.removeEventListener("change", paint);
  }, [view, theme]);
  useEffect(() => view?.setMachine(machine), [view, machine]);
  useEffect(() => view?.setChosen(chosen, editable), [view, chosen, editable]);
  return (
    <div className="bodies-picture">
      <div ref={host} className="viewport" />
      {wrong ? (
        <p className="viewport-wrong muted">The view cannot be shown: {wrong}. The fields beside it work.</p>
      ) : (
        <fieldset className="view-name" aria-label="View of the machine">
          {SIDES.map(([side, label]) => (
            <button key={side} type="button" aria-pressed={name === label} onClick={() => view?.view(side)}>
              {label}
            </button>
          ))}
          <button type="button" onClick={() => view?.frame(false)} title="Frame the machine">
            Frame all
          </button>
          {chosen !== null && (
            <button type="button" onClick={() => view?.frame(true)} title="Frame the chosen body (F in the view)">
              Frame body
            </button>
          )}
        </fieldset>
      )}
    </div>
  );
}
