// The index of the package also wants a validator that needs eval, for its own tests.
import Form from "@rjsf/core/lib/components/Form.js";
import { useCallback, useEffect, useMemo, useRef } from "react";
import { formSchema } from "./schema";
import { FieldOf, ItemOf, ListOf, Nothing, ObjectOf, Plain } from "./templates";
import { validator } from "./validator";
import type { Values } from "./values";
import { type Below, Check, Choose, type FormContext, Input } from "./widgets";
import "./settings.css";

const TEMPLATES = {
  FieldTemplate: FieldOf,
  ObjectFieldTemplate: ObjectOf,
  ArrayFieldTemplate: ListOf,
  ArrayFieldItemTemplate: ItemOf,
  BaseInputTemplate: Input,
  WrapIfAdditionalTemplate: Plain,
  DescriptionFieldTemplate: Nothing,
  TitleFieldTemplate: Nothing,
  ArrayFieldTitleTemplate: Nothing,
  ArrayFieldDescriptionTemplate: Nothing,
  ErrorListTemplate: Nothing,
};

const WIDGETS = { SelectWidget: Choose, CheckboxWidget: Check };

/** What can be set, by the schema of what takes it. A null is as if it were not there, but for choices that have it. */
export function SettingsForm({
  idPrefix,
  schema,
  values,
  onChange,
  why,
  below,
  onBack,
}: {
  readonly idPrefix: string;
  readonly schema: unknown;
  readonly values: Values;
  readonly onChange: (values: Values) => void;
  /** Why nothing can be changed. */
  readonly why?: string | null;
  /** By field. */
  readonly below?: Readonly<Record<string, Below>>;
  /** A field is to be what the parent says again. */
  readonly onBack?: (key: string) => void;
}) {
  const prepared = useMemo(() => formSchema(schema), [schema]);
  const current = useRef(onBack);
  useEffect(() => {
    current.current = onBack;
  });
  const back = useCallback((key: string) => current.current?.(key), []);
  const context: FormContext = { why: why ?? null, below: below ?? {}, onBack: back };
  const given = useMemo(
    () => Object.fromEntries(Object.entries(values).filter(([, value]) => value !== null)),
    [values],
  );
  return (
    <Form
      className="settings-form"
      tagName="div"
      idPrefix={idPrefix}
      schema={prepared}
      uiSchema={{ "ui:submitButtonOptions": { norender: true } }}
      formData={given}
      formContext={context}
      validator={validator}
      templates={TEMPLATES}
      widgets={WIDGETS}
      noHtml5Validate
      showErrorList={false}
      onChange={({ formData }) => onChange((formData ?? {}) as Values)}
    />
  );
}
