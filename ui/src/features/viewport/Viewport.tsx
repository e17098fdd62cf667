import { useEffect, useRef, useState } from "react";
import type { Viewport as Scene } from "../../scene/viewport";
import { lengthFormat } from "../../shared/figures/format";
import { tell } from "../../state/asking/problems";
import { begun } from "../../state/files/beginning";
import { useUnits } from "../../state/window/units";
import { useView } from "../../state/window/view";
import { listenerOf } from "./listener";
import { show } from "./showing";
import "./viewport.css";

/** The view of the design. Its own code is only read when the window is there. */
export function Viewport() {
  const host = useRef<HTMLDivElement>(null);
  const [wrong, setWrong] = useState<string | null>(null);
  useEffect(() => {
    let scene: Scene | null = null;
    let end = () => {};
    let gone = false;
    void Promise.all([import("../../scene/viewport"), begun()]).then(([{ Viewport: View }]) => {
      const element = host.current;
      if (gone || !element) return;
      try {
        scene = new View(
          element,
          listenerOf(() => element.getBoundingClientRect()),
          {
            label: "View of the design. Keys: question mark lists them.",
            lengths: lengthFormat(useUnits.getState().unit),
          },
        );
      } catch (error) {
        const why = error instanceof Error ? error.message : String(error);
        setWrong(why);
        tell(
          "error",
          `The view cannot be shown: ${why}. Update the graphics driver, or start the program with software rendering.`,
          "view",
        );
        return;
      }
      end = show(scene);
      useView.setState({ handle: scene });
    });
    return () => {
      gone = true;
      useView.setState({ handle: null });
      end();
      scene?.dispose();
    };
  }, []);
  return (
    <div ref={host} className="viewport">
      {wrong && (
        <p className="viewport-wrong muted">
          The view cannot be shown. Everything else works: use the lists in the panel.
        </p>
      )}
    </div>
  );
}
