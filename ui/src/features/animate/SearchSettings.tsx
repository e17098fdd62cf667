import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Fold } from "../../shared/controls/Fold";
import { Segmented } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { number } from "../../shared/figures/format";
import { SEARCH_DEFAULTS, setSearch, useSearchSettings, weighsNothing } from "../../state/design/fixes/avoiding";

/** The largest whole number of 32 bits. */
const MOST = 4_294_967_295;

const WEIGHTS = [
  { key: "wire", label: "A wire" },
  { key: "doubled_mm", label: "A doubled mm" },
  { key: "second", label: "A second" },
] as const;

/** How an order of the bends is searched for. */
export function SearchSettings() {
  const settings = useSearchSettings();
  const { effort, seed, weights, wires } = settings;
  const steps = effort ?? SEARCH_DEFAULTS.effort;
  return (
    <Fold title="Search settings" phrase={`${number(steps, 0)} steps, seed ${seed ?? SEARCH_DEFAULTS.seed}`}>
      <Field label="Effort" hint="Steps that may be checked for each number of wires">
        {(ids) => (
          <NumberField
            {...ids}
            label="Effort"
            kind="whole"
            value={steps}
            min={1}
            max={MOST}
            onCommit={(value) => setSearch({ effort: value })}
          />
        )}
      </Field>
      <Field label="Most wires" hint="Left open: as the design is divided, else up to 32">
        {(ids) => (
          <div className="row">
            <NumberField
              {...ids}
              label="Most wires"
              kind="whole"
              value={wires ?? null}
              min={1}
              max={32}
              onCommit={(value) => setSearch({ wires: value })}
            />
            <Button
              kind="link"
              why={wires ? null : "It is left open: as the design is divided, else up to 32."}
              onClick={() => setSearch({ wires: null })}
            >
              Leave open
            </Button>
          </div>
        )}
      </Field>
      <Field label="Seed" hint="The same seed finds the same">
        {(ids) => (
          <NumberField
            {...ids}
            label="Seed"
            kind="whole"
            value={seed ?? SEARCH_DEFAULTS.seed}
            min={0}
            max={MOST}
            onCommit={(value) => setSearch({ seed: value })}
          />
        )}
      </Field>
      <Field
        label="Best is"
        hint={
          weights
            ? "The least sum of these weights"
            : "Fewest wires, then the least doubled length, then the least time"
        }
      >
        {() => (
          <Segmented
            label="What makes an order the best"
            value={weights ? "weighed" : "order"}
            choices={[
              { value: "order", label: "In order" },
              { value: "weighed", label: "Weighed" },
            ]}
            onChoose={(value) => setSearch({ weights: value === "weighed" ? SEARCH_DEFAULTS.weights : null })}
          />
        )}
      </Field>
      {weights &&
        WEIGHTS.map(({ key, label }) => (
          <Field
            key={key}
            label={label}
            error={weighsNothing(settings) && key === "wire" ? "One of the weights has to be more than 0" : null}
          >
            {(ids) => (
              <NumberField
                {...ids}
                label={label}
                kind="whole"
                value={weights[key] ?? 0}
                min={0}
                max={MOST}
                onCommit={(value) => setSearch({ weights: { ...weights, [key]: value } })}
              />
            )}
          </Field>
        ))}
    </Fold>
  );
}
