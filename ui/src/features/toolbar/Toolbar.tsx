import { Fragment } from "react";
import type { Tool } from "../../scene/interface";
import { Icon, type IconName } from "../../shared/controls/icons";
import { Tooltip } from "../../shared/layers/Tooltip";
import { run, useWhyNot } from "../../state/window/commands";
import { type CommandId, keyOf } from "../../state/window/keys";
import { useView } from "../../state/window/view";
import "./toolbar.css";

interface Entry {
  readonly command: CommandId;
  readonly icon: IconName;
  readonly label: string;
  /** A tool stays until another is chosen. */
  readonly tool?: Tool;
}

const GROUPS: readonly (readonly Entry[])[] = [
  [
    { command: "tool-select", icon: "select", label: "Select", tool: "select" },
    { command: "tool-trace", icon: "trace", label: "Trace on the stencil", tool: "trace" },
    { command: "tool-draw", icon: "draw", label: "Draw on a plane", tool: "draw" },
    { command: "tool-measure", icon: "measure", label: "Measure between two things", tool: "measure" },
  ],
  [
    { command: "move", icon: "move", label: "Move" },
    { command: "extrude", icon: "extrude", label: "Extrude an edge" },
    { command: "split", icon: "split", label: "Split an edge" },
    { command: "merge", icon: "merge", label: "Merge vertices" },
    { command: "connect", icon: "connect", label: "Connect vertices" },
    { command: "mirror", icon: "mirror", label: "Mirror" },
  ],
  [{ command: "keys", icon: "help", label: "Keys" }],
];

function ToolButton({ command, icon, label, tool }: Entry) {
  const now = useView((view) => view.tool);
  const why = useWhyNot(command);
  const keys = keyOf(command);
  return (
    <Tooltip text={why ? `${label}. ${why}` : label} keys={keys}>
      <button
        type="button"
        className="tool"
        aria-label={keys ? `${label} (${keys})` : label}
        aria-pressed={tool === undefined ? undefined : tool === now}
        aria-disabled={why ? true : undefined}
        onClick={() => run(command)}
      >
        <Icon name={icon} size={20} />
      </button>
    </Tooltip>
  );
}

/** The tools and what is done most, with their keys. */
export function Toolbar() {
  return (
    <div className="toolbar" role="toolbar" aria-label="Tools" aria-orientation="vertical">
      {GROUPS.map((group, index) => (
        <Fragment key={group[0]?.command}>
          {index > 0 && <hr className="toolbar-rule" />}
          {group.map((entry) => (
            <ToolButton key={entry.command} {...entry} />
          ))}
        </Fragment>
      ))}
    </div>
  );
}
