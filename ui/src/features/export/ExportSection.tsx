import { useEffect } from "react";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Icon } from "../../shared/controls/icons";
import { Line } from "../../shared/lists/Line";
import { useDesign } from "../../state/design/design";
import { chooseFormat, chosenFormat, loadFormats, useExports } from "../../state/files/exports";
import { useFiles } from "../../state/files/files";
import { useMachines } from "../../state/machine/machines";
import { useUi } from "../../state/window/ui";
import { Part, Section } from "../panel/Section";
import { FormatSettings } from "./FormatSettings";
import { grouped } from "./groups";
import { Later } from "./Later";
import { Preview } from "./Preview";
import { WriteFile } from "./WriteFile";
import "./export.css";

/** What can be written of the design, and writing it. */
export function ExportSection() {
  const store = useExports();
  const open = useUi((ui) => ui.open.includes("export"));
  const machine = useDesign((design) => design.state?.machine ?? null);
  const changes = useMachines((machines) => machines.changes);
  const opened = useFiles((files) => files.opened);
  const empty = useDesign((design) => design.edges.size === 0);
  const format = chosenFormat(store);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a changed profile may offer other formats
  useEffect(() => {
    if (open && machine) void loadFormats();
  }, [open, machine, changes]);
  return (
    <Section
      id="export"
      title="Export"
      phrase={
        format?.name ??
        (store.problem ? "nothing to export" : machine ? "files for machines and people" : "no machine chosen")
      }
    >
      {store.problem && (
        <ul>
          <Line
            tone="error"
            what="Could not list the export formats"
            sub={store.problem}
            action={
              <Button kind="link" onClick={() => void loadFormats()}>
                Ask again
              </Button>
            }
          />
        </ul>
      )}
      {store.problems.map((problem) => (
        <ul key={problem}>
          <Line tone="warning" what="A driver did not answer" sub={problem} />
        </ul>
      ))}
      {machine && <ForMachine />}
      {store.formats && format && <Formats />}
      {format && (
        <>
          <FormatSettings format={format} />
          {empty ? (
            <p className="muted">Draw an edge to see a preview of the file here.</p>
          ) : (
            <>
              <Preview format={format} />
              <WriteFile key={`${opened} ${format.id}`} format={format} />
            </>
          )}
          <Part title="To continue later">
            <Later />
          </Part>
        </>
      )}
    </Section>
  );
}

/** Whose files these are: who wants one for another machine looks for it here. */
function ForMachine() {
  const machine = useDesign((design) => design.state?.machine ?? null);
  const machines = useMachines((store) => store.machines);
  const name = machines?.find(({ id }) => id === machine)?.name ?? machine;
  return (
    <div className="row">
      <span className="muted small grow ellipsis" title={`For ${name}`}>
        For {name}
      </span>
      <Button kind="link" onClick={() => useUi.getState().chooseMachine(true)}>
        Another machine…
      </Button>
    </div>
  );
}

function Formats() {
  const store = useExports();
  const machine = useDesign((design) => design.state?.machine ?? null);
  const driver = useMachines((machines) => machines.machines?.find(({ id }) => id === machine)?.driver ?? null);
  const format = chosenFormat(store);
  return (
    <Field label="Format">
      {(ids) => (
        <span className="select">
          <select {...ids} value={format?.id} onChange={(event) => chooseFormat(event.currentTarget.value)}>
            {grouped(store.formats ?? [], driver).map((group) => (
              <optgroup key={group.title} label={group.title}>
                {group.formats.map(({ id, name }) => (
                  <option key={id} value={id}>
                    {name}
                  </option>
                ))}
              </optgroup>
            ))}
          </select>
          <Icon name="down" size={12} />
        </span>
      )}
    </Field>
  );
}
