import { useEffect } from "react";
import { Button } from "../../shared/Button";
import { Field } from "../../shared/Field";
import { Icon } from "../../shared/icons";
import { Line } from "../../shared/Line";
import { Part, Section } from "../../shared/Section";
import { useDesign } from "../../state/design";
import { chooseFormat, chosenFormat, loadFormats, useExports } from "../../state/exports";
import { useFiles } from "../../state/files";
import { useMachines } from "../../state/machines";
import { useUi } from "../../state/ui";
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
  useEffect(() => {
    if (open && machine) void loadFormats();
  }, [open, machine, changes]);
  return (
    <Section id="export" title="Export" phrase={format?.name ?? (store.problem ? "nothing can be written" : machine ? "files for machines and people" : "no machine chosen")}>
      {store.problem && (
        <ul>
          <Line tone="error" what="It is not known what can be written" sub={store.problem} action={<Button kind="link" onClick={() => void loadFormats()}>Ask again</Button>} />
        </ul>
      )}
      {store.problems.map((problem) => (
        <ul key={problem}>
          <Line tone="warning" what="A driver could not be asked" sub={problem} />
        </ul>
      ))}
      {store.formats && format && <Formats />}
      {format && (
        <>
          <FormatSettings format={format} />
          {empty ? (
            <p className="muted">As soon as there is an edge, what would be written of it is shown here.</p>
          ) : (
            <>
              <Preview format={format} />
              <WriteFile key={`${opened} ${format.id}`} format={format} />
            </>
          )}
          <Part title="To go on later">
            <Later />
          </Part>
        </>
      )}
    </Section>
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
