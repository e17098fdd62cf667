import type { SceneJoint } from "../../scene/interface";
import { Select } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { useDesign } from "../../state/design/design";
import { setJoint } from "../../state/design/operations";
import { useSelection, verticesOf } from "../../state/design/selection";

type Kind = SceneJoint["kind"];

const CHOICES: readonly { readonly value: Kind | "none" | "several"; readonly label: string }[] = [
  { value: "none", label: "No joint" },
  { value: "snap-fit", label: "Snap-fit" },
  { value: "solder", label: "Solder" },
  { value: "zip-tie", label: "Zip tie" },
];

/** A joint of a new kind weighs this until somebody says what it weighs, g. */
const NEW_MASS_G = 1;

/** What holds the struts together at the selected vertices; `none`: why there are none. */
export function Joint({ none }: { readonly none: string | null }) {
  const design = useDesign();
  const selection = useSelection();
  const joints = verticesOf(selection, design).map((id) => design.vertices.get(id)?.joint);
  const [first] = joints;
  const alike = joints.every((joint) => joint?.kind === first?.kind && joint?.mass_g === first?.mass_g);
  const value = alike ? (first?.kind ?? "none") : "several";
  const choices = alike ? CHOICES : [{ value: "several" as const, label: "Different joints" }, ...CHOICES];
  const choose = (kind: (typeof CHOICES)[number]["value"]) => {
    if (kind === "none") void setJoint(null);
    else if (kind !== "several") void setJoint({ kind, mass_g: first?.mass_g ?? NEW_MASS_G });
  };
  return (
    <div className="joint">
      <span className="muted">Joint</span>
      <Select
        aria-label="Joint"
        disabled={none !== null}
        title={none ?? undefined}
        choices={choices}
        value={value}
        onChoose={choose}
      />
      {alike && first && (
        <NumberField
          label="Mass of the joint"
          kind="number"
          unit="g"
          min={0}
          value={first.mass_g}
          onCommit={(mass_g) => void setJoint({ kind: first.kind, mass_g })}
        />
      )}
    </div>
  );
}
