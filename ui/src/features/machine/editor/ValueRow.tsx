import { useId, useState } from "react";
import type { ProfileView, ValueReport } from "../../../generated/responses";
import { Button } from "../../../shared/controls/Button";
import { Checkbox, Select } from "../../../shared/controls/inputs";
import { NumberField } from "../../../shared/controls/NumberField";
import { useUnit } from "../../../shared/figures/unit";
import { useMachines } from "../../../state/machine/machines";
import {
  isOwn,
  type PlainValue,
  reportOf,
  setValue,
  takeBack,
  typeDimension,
  useProfile,
} from "../../../state/machine/profile";
import { CommitText } from "./CommitText";
import type { FieldSpec } from "./fields";
import { SourceForm } from "./SourceForm";
import { Springback } from "./Springback";
import { beforeOf, sourceOf } from "./words";

/** A value with its source; what is changed is marked, says what it was, and can be taken back. */
export function ValueRow({ spec, why }: { readonly spec: FieldSpec; readonly why: string | null }) {
  const view = useProfile((store) => store.view);
  const refused = useProfile((store) => (store.refused?.key === spec.key ? store.refused.message : null));
  const [editing, setEditing] = useState(false);
  const id = useId();
  const unit = useUnit();
  const value = reportOf(view, spec.kind === "springback" ? "springback.model" : spec.key);
  const own = isOwn(view, spec.key);
  const stated = spec.kind === "springback" ? statedOf(view?.profile.values ?? []) : value;
  const missing = value === null || value.value === null;
  return (
    <fieldset
      className={own ? "value-row own" : "value-row"}
      aria-labelledby={id}
      data-key={spec.key}
      data-wide={spec.kind === "springback" || undefined}
    >
      <span id={id} className="value-label" title={spec.hint}>
        {spec.label}
        {own && <span className="value-changed">changed</span>}
      </span>
      <div className="value-control">
        <Control spec={spec} value={value} why={why} labelledBy={id} />
      </div>
      <div className="value-below small">
        {refused ? (
          <span className="value-refused" role="alert" title={refused}>
            {refused}
          </span>
        ) : (
          <span className="value-source ellipsis" title={sourceOf(stated)}>
            {own && beforeOf(spec, stated, unit)}
            {sourceOf(stated)}
          </span>
        )}
        {!why && !missing && (
          <Button kind="link" aria-label={`Change the source of ${spec.label}`} onClick={() => setEditing(!editing)}>
            Source…
          </Button>
        )}
        {!why && own && (
          <Button kind="link" aria-label={`Take back ${spec.label}`} onClick={() => void takeBack(spec.key)}>
            Take back
          </Button>
        )}
        {!why && !own && !missing && spec.absent && spec.kind !== "text" && (
          <Button kind="link" title={`Set to “${spec.absent}”`} onClick={() => void setValue(spec.key, null)}>
            Remove
          </Button>
        )}
      </div>
      {editing && value && (
        <SourceForm
          of={spec.label}
          source={{ text: stated?.source ?? "", measured: stated?.measured ?? false }}
          onSet={(source) => setValue(spec.key, wholeOf(spec, view, value), source)}
          onDone={() => setEditing(false)}
        />
      )}
    </fieldset>
  );
}

/** A value as it is set anew with another source: a springback as a whole, from its model and what it has. */
function wholeOf(spec: FieldSpec, view: ProfileView | null, { value }: ValueReport): PlainValue {
  if (spec.kind !== "springback") return value as PlainValue;
  const part = (key: string) => (reportOf(view, `springback.${key}`)?.value ?? null) as PlainValue;
  if (part("model") === "constant") return { model: "constant", angle_deg: part("angle_deg") };
  const negative = part("negative");
  return { model: "table", positive: part("positive"), ...(negative === null ? {} : { negative }) };
}

/** Of a springback what states a source: the pairs of a table, or the one angle. */
const statedOf = (values: readonly ValueReport[]): ValueReport | null =>
  values.find(({ key }) => key === "springback.positive" || key === "springback.angle_deg") ?? null;

function Control({
  spec,
  value,
  why,
  labelledBy,
}: {
  readonly spec: FieldSpec;
  readonly value: ValueReport | null;
  readonly why: string | null;
  readonly labelledBy: string;
}) {
  const materials = useMachines((store) => store.materials);
  const set = (plain: PlainValue) => void setValue(spec.key, plain);
  const plain = (value?.value ?? null) as PlainValue;
  const placeholder = spec.absent ?? "";
  switch (spec.kind) {
    case "length":
    case "number":
      return (
        <NumberField
          label={spec.label}
          kind={spec.kind === "length" ? "fine" : "number"}
          unit={spec.kind === "length" ? (spec.per ?? "") : (spec.unit ?? "")}
          value={typeof plain === "number" ? plain : null}
          placeholder={placeholder}
          why={why}
          onType={(typed, isTyping) => {
            // What is half written may become a number with the next key.
            if (typed !== null || !isTyping) void typeDimension(spec.key, typed);
          }}
          onCommit={set}
        />
      );
    case "yes-no":
      return (
        <Checkbox checked={plain === true} onChange={set} why={why}>
          {spec.key.startsWith("compensation.") ? "by this program" : "yes"}
        </Checkbox>
      );
    case "sign":
      return (
        <Select
          aria-labelledby={labelledBy}
          value={plain === -1 ? "-1" : "1"}
          disabled={Boolean(why)}
          choices={[
            { value: "1", label: "As designed (+1)" },
            { value: "-1", label: "Reversed (−1)" },
          ]}
          onChoose={(chosen) => set(Number(chosen))}
        />
      );
    case "choice":
      return (
        <Select
          aria-labelledby={labelledBy}
          value={String(plain)}
          disabled={Boolean(why)}
          choices={spec.choices}
          onChoose={set}
        />
      );
    case "material":
      return (
        <Select
          aria-labelledby={labelledBy}
          value={String(plain ?? "")}
          disabled={Boolean(why)}
          choices={(materials ?? []).map(({ id, name }) => ({ value: id, label: name }))}
          onChoose={set}
        />
      );
    case "text":
      return (
        <CommitText
          label={spec.label}
          value={typeof plain === "string" ? plain : ""}
          placeholder={placeholder}
          why={why}
          onCommit={(text) => set(text === "" ? null : text)}
        />
      );
    case "springback":
      return <Springback why={why} />;
  }
}
