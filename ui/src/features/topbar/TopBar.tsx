import { Button } from "../../shared/controls/Button";
import { Either } from "../../shared/controls/Either";
import { useUnit } from "../../shared/figures/unit";
import { Guard } from "../../shared/Guard";
import { MenuBar } from "../../shared/layers/Menu";
import { Tooltip } from "../../shared/layers/Tooltip";
import { useDesign } from "../../state/design/design";
import { run, useWhyNot } from "../../state/window/commands";
import { keyOf } from "../../state/window/keys";
import { MachinePicker } from "../machine/choosing/MachinePicker";
import { MaterialPicker } from "../machine/choosing/MaterialPicker";
import { StopButton } from "../run/StopButton";
import { menus } from "./menus";
import "./topbar.css";

function Back({ command }: { readonly command: "undo" | "redo" }) {
  const state = useDesign((design) => design.state);
  const why = useWhyNot(command);
  const label =
    `${command === "undo" ? "Undo" : "Redo"} ${(command === "undo" ? state?.undo : state?.redo) ?? ""}`.trim();
  return (
    <Tooltip text={why ?? label} keys={keyOf(command)} side="bottom">
      <Button kind="quiet" icon={command} aria-label={label} why={why} onClick={() => run(command)} />
    </Tooltip>
  );
}

/** What is open, the menus, and what the wire is bent with: never out of sight. */
export function TopBar() {
  const state = useDesign((design) => design.state);
  const unit = useUnit();
  const name = state?.name || "New design";
  return (
    <header className="top-bar">
      <h1 className="top-name" title={state?.file ?? "Not saved yet"}>
        <span className="ellipsis">{name}</span>
        {state?.changed ? (
          <span className="top-dot" title="Unsaved changes">
            <span className="visually-hidden">, unsaved changes</span>
          </span>
        ) : (
          <span className="top-dot saved" />
        )}
      </h1>
      <Guard name="The menus">
        <MenuBar menus={menus} />
      </Guard>
      <div className="row top-back">
        <Back command="undo" />
        <Back command="redo" />
      </div>
      <div className="row top-made">
        <Guard name="Machine and wire">
          <MachinePicker />
          <MaterialPicker />
        </Guard>
        <Button
          kind="quiet"
          aria-label={`${unit === "mm" ? "mm" : "in"}, the unit of lengths: change it`}
          title={unit === "mm" ? "Show lengths in inches" : "Show lengths in millimetres"}
          onClick={() => run("units")}
        >
          {unit === "mm" ? <Either shown="mm" other="in" /> : <Either shown="in" other="mm" />}
        </Button>
      </div>
      <StopButton />
    </header>
  );
}
