import { Dialog } from "../../shared/layers/Dialog";
import { KEYS } from "../../state/window/keys";
import { useUi } from "../../state/window/ui";

const GROUPS = ["Tools", "View", "Edit", "File", "Machine", "Help"] as const;

const POINTER: readonly (readonly [string, string])[] = [
  ["Orbit", "Middle or right button; Alt and left"],
  ["Pan", "Shift and middle button"],
  ["Zoom", "Wheel"],
  ["Orbit by keys", "Arrows, when the view has the focus"],
  ["Pan by keys", "Shift and arrows"],
  ["Zoom by keys", "+ and \u2212"],
  ["Box select", "Drag over empty space"],
  ["Add to the selection", "Shift"],
  ["Select connected", "Double click"],
  ["Without snapping", "Ctrl while moving or drawing"],
  ["Without steps of 15°", "Shift while drawing"],
];

/** All keys, from the same table that they work by. */
export function KeysDialog() {
  const shown = useUi(({ dialog }) => dialog === "keys");
  if (!shown) return null;
  return (
    <Dialog title="Keys" wide onClose={() => useUi.getState().showDialog(null)}>
      <div className="keys">
        {GROUPS.map((group) => (
          <section key={group} className="keys-group">
            <h3>{group}</h3>
            <dl>
              {KEYS.filter((entry) => entry.group === group).map(({ command, label, keys }) => (
                <div key={command} className="keys-row">
                  <dt>{label}</dt>
                  <dd>
                    {keys.map((key) => (
                      <kbd key={key}>{key.replace("Escape", "Esc").replaceAll("+", " ")}</kbd>
                    ))}
                  </dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
        <section className="keys-group">
          <h3>Pointer</h3>
          <dl>
            {POINTER.map(([label, how]) => (
              <div key={label} className="keys-row">
                <dt>{label}</dt>
                <dd className="muted">{how}</dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
    </Dialog>
  );
}
