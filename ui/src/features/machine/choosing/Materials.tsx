import { Icon } from "../../../shared/controls/icons";
import { useUnit } from "../../../shared/figures/unit";
import { useDesign } from "../../../state/design/design";
import { chooseMaterial, useMachines } from "../../../state/machine/machines";
import { figures, misfit } from "./fit";

/** The wires to choose from. One that does not fit says so and can be chosen anyway: the checks then show what is wrong. */
export function Materials({ onDone }: { readonly onDone?: () => void }) {
  const { materials, machines } = useMachines();
  const state = useDesign((design) => design.state);
  const unit = useUnit();
  if (!materials) return <p className="muted">Loading materials…</p>;
  const machine = machines?.find(({ id }) => id === state?.machine) ?? null;
  const choose = async (id: string) => {
    if (id !== state?.material) await chooseMaterial(id);
    onDone?.();
  };
  // Those that fit first; otherwise as they come.
  const sorted = materials.toSorted(
    (a, b) => Number(misfit(a, machine, unit) !== null) - Number(misfit(b, machine, unit) !== null),
  );
  return (
    <ul className="choice-list" aria-label="Wire">
      {sorted.map((material) => {
        const wrong = misfit(material, machine, unit);
        const own = material.id === state?.material;
        return (
          <li key={material.id}>
            <button type="button" className="choice" aria-pressed={own} onClick={() => void choose(material.id)}>
              <span className="choice-check">{own && <Icon name="check" />}</span>
              <span className="choice-text">
                <span>{material.name}</span>
                <span className="choice-figures small">
                  {figures(material, unit).map(([what, value]) => (
                    <span key={what}>
                      <span className="muted">{what}</span> {value}
                    </span>
                  ))}
                </span>
                {wrong && (
                  <span className="choice-wrong small">
                    <Icon name="warning" size={12} /> {wrong}
                  </span>
                )}
              </span>
            </button>
          </li>
        );
      })}
    </ul>
  );
}
