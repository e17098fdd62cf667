import type { ReactNode } from "react";
import { Button } from "../../shared/controls/Button";
import { Icon } from "../../shared/controls/icons";
import { detach, selectedEdges } from "../../state/design/operations";
import { run, useWhyNot, whyNot } from "../../state/window/commands";
import { type CommandId, keyOf } from "../../state/window/keys";
import { type OperationName, useUi } from "../../state/window/ui";
import { ArrayForm, ScaleForm } from "./copies";
import { FilletForm } from "./Fillet";
import { ExtrudeForm, MergeForm, MirrorForm, RoundForm, SplitForm, StraightenForm } from "./forms";
import { RotateForm } from "./Rotate";

const FORMS: readonly { readonly name: OperationName; readonly label: string; readonly form: () => ReactNode }[] = [
  { name: "split", label: "Split", form: () => <SplitForm /> },
  { name: "merge", label: "Merge", form: () => <MergeForm /> },
  { name: "extrude", label: "Extrude", form: () => <ExtrudeForm /> },
  { name: "rotate", label: "Rotate", form: () => <RotateForm /> },
  { name: "mirror", label: "Mirror", form: () => <MirrorForm /> },
  { name: "array", label: "Array", form: () => <ArrayForm /> },
  { name: "scale", label: "Scale", form: () => <ScaleForm /> },
  { name: "straighten", label: "Straighten", form: () => <StraightenForm /> },
  { name: "round", label: "Round", form: () => <RoundForm /> },
  { name: "fillet", label: "Fillet", form: () => <FilletForm /> },
];

/** An operation at once, without parameters. */
function Now({ command, label }: { readonly command: CommandId; readonly label: string }) {
  const why = useWhyNot(command);
  return (
    <Button small why={why} title={keyOf(command)} onClick={() => run(command)}>
      {label}
    </Button>
  );
}

function Operation({ name, label, form }: (typeof FORMS)[number]) {
  const open = useUi((ui) => ui.operation === name);
  return (
    <div className="operation" id={`operation-${name}`}>
      <button
        type="button"
        className="operation-head"
        aria-expanded={open}
        onClick={() => useUi.getState().showOperation(open ? null : name)}
      >
        <Icon name={open ? "down" : "right"} size={12} />
        <span className="grow">{label}</span>
        <span className="muted">{keyOf(name)}</span>
      </button>
      {open && <div className="operation-form">{form()}</div>}
    </div>
  );
}

/** What can be done with the selection: at once, or with figures. */
export function Operations() {
  // The reasons of the buttons depend on the selection.
  useWhyNot("delete");
  const noEdges = selectedEdges().length === 0 ? "Select the edges to detach first." : null;
  return (
    <div>
      <div className="row wrap operations-now">
        <Now command="connect" label="Connect" />
        <Now command="duplicate" label="Duplicate" />
        <Now command="delete" label="Delete" />
        <Now command="construction" label="Construction" />
        <Button
          small
          why={whyNot("delete") ?? noEdges}
          title="Detach the selected edges: two wires that touch"
          onClick={() => void detach()}
        >
          Detach
        </Button>
      </div>
      {FORMS.map((entry) => (
        <Operation key={entry.name} {...entry} />
      ))}
    </div>
  );
}
