import { Fragment } from "react";
import { Icon, type IconName } from "../../shared/icons";
import { Tooltip } from "../../shared/Tooltip";
import { run, useWhyNot } from "../../state/commands";
import { type CommandId, keyOf } from "../../state/keys";
import { useView } from "../../state/view";
import type { Tool } from "../../scene/interface";
import "./toolbar.css";

interface Entry {
  readonly command: CommandId;
  readonly icon: IconName;
  readonly label: string;
  /** A tool stays until another is taken up. */
  readonly tool?: Tool;
}

const GROUPS: readonly (readonly Entry[])[] = [
  [
    { command: "tool-select", icon: "select", label: "Select", tool: "select" },
    { command: "tool-trace", icon: "trace", label: "Trace on the stencil", tool: "trace" },
    { command: "tool-draw", icon: "draw", label: "Draw on a plane", tool: "draw" },
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

function Tool({ command, icon, label, tool }: Entry) {
  const now = useView((view) => view.tool);
  const why = useWhyNot(command);
  const keys = keyOf(command);
  return (
    <Tooltip text={why ? `${label}: ${why.charAt(0).toLowerCase()}${why.slice(1)}` : label} keys={keys}>
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
          {index > 0 && <div className="toolbar-rule" role="separator" />}
          {group.map((entry) => (
            <Tool key={entry.command} {...entry} />
          ))}
        </Fragment>
      ))}
    </div>
  );
}
