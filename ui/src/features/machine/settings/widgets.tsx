import type { BaseInputTemplateProps, RJSFSchema, WidgetProps } from "@rjsf/utils";
import { Button } from "../../../shared/controls/Button";
import { Select, TextInput } from "../../../shared/controls/inputs";
import { NumberField } from "../../../shared/controls/NumberField";
import { sameValue } from "./values";

/** What is said under a field of the outermost object: where its value comes from. */
export interface Below {
  readonly phrase: string;
  readonly changed: boolean;
  /** Whether it can be what the parent says again. */
  readonly back: boolean;
}

/** What the form tells its fields. Values, so that the form sees when they are others: it takes any function for the same. */
export interface FormContext {
  /** Why nothing can be changed. */
  readonly why: string | null;
  readonly below: Readonly<Record<string, Below>>;
  /** The same one all the time. */
  readonly onBack: (key: string) => void;
}

const whyOf = (props: WidgetProps): string | null => (props.registry.formContext as FormContext).why;
const isNumber = (schema: RJSFSchema): boolean => schema.type === "number" || schema.type === "integer";

/** Numbers and lines of text. */
export function Input(props: BaseInputTemplateProps) {
  const { id, schema, value, onChange, label } = props;
  const why = whyOf(props);
  if (isNumber(schema)) {
    const { minimum, maximum } = schema;
    return (
      <span className="row">
        <NumberField
          id={id}
          aria-describedby={`${id}-below`}
          label={label}
          kind={schema.type === "integer" ? "whole" : "number"}
          value={typeof value === "number" ? value : null}
          placeholder="not set"
          why={why}
          {...(typeof minimum === "number" ? { min: minimum } : {})}
          {...(typeof maximum === "number" ? { max: maximum } : {})}
          onCommit={(number) => onChange(number)}
        />
        {schema.nullable === true && typeof value === "number" && !why && (
          <Button
            kind="quiet"
            small
            icon="close"
            aria-label={`Do not set ${label}`}
            title="Do not set"
            onClick={() => onChange(undefined)}
          />
        )}
      </span>
    );
  }
  return (
    <TextInput
      id={id}
      aria-describedby={`${id}-below`}
      aria-label={label}
      value={typeof value === "string" ? value : ""}
      readOnly={why !== null}
      aria-disabled={why !== null || undefined}
      title={why ?? undefined}
      onChange={(event) => onChange(event.currentTarget.value === "" ? undefined : event.currentTarget.value)}
    />
  );
}

/** One of several values, which need not be texts. */
export function Choose(props: WidgetProps) {
  const { id, value, onChange, label, options } = props;
  const why = whyOf(props);
  const all = options.enumOptions ?? [];
  const at = all.findIndex((option) => sameValue(option.value, value));
  return (
    <Select
      id={id}
      aria-label={label}
      aria-describedby={`${id}-below`}
      disabled={why !== null}
      title={why ?? undefined}
      value={String(at)}
      onChoose={(chosen) => onChange(all[Number(chosen)]?.value)}
      choices={[
        ...(at < 0 ? [{ value: "-1", label: "not set" }] : []),
        ...all.map((option, index) => ({ value: String(index), label: option.label })),
      ]}
    />
  );
}

export function Check(props: WidgetProps) {
  const { id, value, onChange } = props;
  const why = whyOf(props);
  return (
    <span className="settings-check">
      <input
        type="checkbox"
        id={id}
        aria-describedby={`${id}-below`}
        checked={value === true}
        disabled={why !== null}
        title={why ?? undefined}
        onChange={(event) => onChange(event.currentTarget.checked)}
      />
    </span>
  );
}
