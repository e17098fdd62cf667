import type {
  ArrayFieldItemTemplateProps,
  ArrayFieldTemplateProps,
  FieldTemplateProps,
  ObjectFieldTemplateProps,
  WrapIfAdditionalTemplateProps,
} from "@rjsf/utils";
import { ADDITIONAL_PROPERTY_FLAG } from "@rjsf/utils";
import { Button } from "../../../shared/controls/Button";
import { TextInput } from "../../../shared/controls/inputs";
import { worded } from "./schema";
import type { FormContext } from "./widgets";

const contextOf = (props: { registry: { formContext: unknown } }): FormContext =>
  props.registry.formContext as FormContext;

/** A label, the control, and under it what it means and where its value comes from. */
export function FieldOf(props: FieldTemplateProps) {
  const { id, label, children, schema, fieldPathId, rawDescription, hidden } = props;
  const key = fieldPathId.path.at(-1);
  if (hidden) return null;
  if (ADDITIONAL_PROPERTY_FLAG in schema) return <Named {...props}>{children}</Named>;
  // The whole form, and items of lists, need no label of their own.
  if (key === undefined || typeof key === "number") return children;
  const { below: all, onBack } = contextOf(props);
  const below = fieldPathId.path.length === 1 ? all[key] : undefined;
  const { unit } = worded(String(key));
  const group = schema.type === "object" || schema.type === "array";
  return (
    <div className={group ? "settings-field group" : "settings-field"}>
      <label htmlFor={id}>
        {label}
        {unit && <span className="muted">, {unit}</span>}
      </label>
      <div className="settings-control">{children}</div>
      <p id={`${id}-below`} className="settings-below">
        {rawDescription}
        {rawDescription && below && " · "}
        {below && (
          <span className={below.changed ? "settings-source changed" : "settings-source"}>
            {below.phrase}
            {below.back && (
              <Button kind="link" onClick={() => onBack(String(key))}>
                use the inherited value
              </Button>
            )}
          </span>
        )}
      </p>
    </div>
  );
}

export function ObjectOf({ properties, onAddProperty, schema, title, ...props }: ObjectFieldTemplateProps) {
  const why = contextOf(props).why;
  return (
    <div className="settings-object">
      {properties.map(({ content }) => content)}
      {schema.additionalProperties !== undefined && schema.additionalProperties !== false && (
        <div>
          <Button small icon="plus" why={why} onClick={onAddProperty} aria-label={`Add to ${title}`}>
            Add
          </Button>
        </div>
      )}
    </div>
  );
}

/** A field whose key a person gives. */
function Named({ id, label, children, onKeyRenameBlur, onRemoveProperty, ...props }: WrapIfAdditionalTemplateProps) {
  const why = contextOf(props).why;
  return (
    <div className="settings-item">
      <TextInput
        aria-label="Key"
        id={`${id}-key`}
        defaultValue={label}
        readOnly={why !== null}
        title={why ?? undefined}
        onBlur={onKeyRenameBlur}
      />
      {children}
      <Button kind="quiet" small icon="trash" aria-label={`Remove ${label}`} why={why} onClick={onRemoveProperty} />
    </div>
  );
}

export const Plain = ({ children }: WrapIfAdditionalTemplateProps) => <>{children}</>;

export function ListOf({ items, onAddClick, title, ...props }: ArrayFieldTemplateProps) {
  const why = contextOf(props).why;
  return (
    <div className="settings-list">
      {items}
      {items.length === 0 && <span className="muted small">none</span>}
      <div>
        <Button small icon="plus" why={why} onClick={onAddClick} aria-label={`Add to ${title}`}>
          Add
        </Button>
      </div>
    </div>
  );
}

export function ItemOf({ children, buttonsProps, index, ...props }: ArrayFieldItemTemplateProps) {
  const why = contextOf(props).why;
  const { hasMoveUp, onMoveUpItem, onRemoveItem } = buttonsProps;
  return (
    <div className="settings-item">
      <div className="grow">{children}</div>
      <Button
        kind="quiet"
        small
        icon="up"
        aria-label={`Move ${index + 1} up`}
        why={why ?? (hasMoveUp ? null : "It is the first.")}
        onClick={onMoveUpItem}
      />
      <Button kind="quiet" small icon="trash" aria-label={`Remove ${index + 1}`} why={why} onClick={onRemoveItem} />
    </div>
  );
}

export const Nothing = () => null;
