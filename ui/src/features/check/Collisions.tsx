import { Button } from "../../shared/controls/Button";
import { number, sentence } from "../../shared/figures/format";
import { Line } from "../../shared/lists/Line";
import { useWork } from "../../state/asking/work";
import { lookForCollisions, stopCollisions, useCollisions } from "../../state/design/collisions";
import { useDesign } from "../../state/design/design";
import { EnterDimensions } from "./EnterDimensions";
import { estimatesOf } from "./texts";

/** How the check for collisions stands. What it has found is in the list, like all other findings. */
export function Collisions() {
  const { stands, long, problem } = useCollisions();
  const found = useDesign(({ collisions }) => collisions?.found);
  // What was found a moment ago stays until the next answer is there.
  if (found && (stands === "running" || stands === "done")) {
    if (!found.checked)
      return (
        <Line tone="info" what="Wires without a program are not checked for collisions" sub={estimatesOf(found)} />
      );
    if (found.contacts.some(({ depth_mm }) => depth_mm >= 0)) return null;
    return (
      <Line
        tone="fine"
        what="No collision found with the machine or with the wire itself"
        sub={estimatesOf(found)}
        action={found.estimates > 0 && <EnterDimensions />}
      />
    );
  }
  switch (stands) {
    case "running":
      return long ? <Long /> : <Line tone="info" what={<span className="muted">Checking for collisions…</span>} />;
    case "waiting":
      return <Line tone="info" what={<span className="muted">Collisions are checked after the drag</span>} />;
    case "stopped":
      return <Line tone="info" what="Collisions are not checked" sub="The check was stopped." action={<Again />} />;
    case "failed":
      return (
        <Line tone="warning" what="Collisions could not be checked" sub={sentence(problem ?? "")} action={<Again />} />
      );
    default:
      return null;
  }
}

/** A large design: how far it is, and a way out. */
function Long() {
  const work = useWork(({ works }) => works.get("collisions"));
  const far = work && work.of > 0 ? `Step ${number(work.done + 1, 0)} of ${number(work.of, 0)}. ` : "";
  return (
    <Line
      tone="info"
      what="Checking for collisions takes long for this design"
      sub={`${far}You can go on working meanwhile.`}
      action={
        <Button kind="link" onClick={stopCollisions}>
          Stop
        </Button>
      }
    />
  );
}

function Again() {
  return (
    <Button kind="link" onClick={lookForCollisions}>
      Check
    </Button>
  );
}
