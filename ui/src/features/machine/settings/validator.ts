import type { RJSFSchema, ValidatorType } from "@rjsf/utils";

type Schema = Record<string, unknown>;

const isObject = (value: unknown): value is Schema =>
  typeof value === "object" && value !== null && !Array.isArray(value);

function isOfType(type: unknown, value: unknown): boolean {
  switch (type) {
    case "null":
      return value === null;
    case "array":
      return Array.isArray(value);
    case "object":
      return isObject(value);
    case "integer":
      return typeof value === "number" && Number.isInteger(value);
    case "number":
    case "string":
    case "boolean":
      return typeof value === type;
    default:
      return true;
  }
}

/** Whether a value has the shape that a schema asks for: as much as is needed to tell alternatives from each other. */
export function hasShape(schema: unknown, value: unknown): boolean {
  if (!isObject(schema)) return schema !== false;
  if ("const" in schema && JSON.stringify(schema.const) !== JSON.stringify(value ?? null)) return false;
  const { enum: values, type, properties, required, oneOf, anyOf, allOf } = schema;
  if (Array.isArray(values) && !values.includes(value)) return false;
  if (value === undefined) return true;
  const types = Array.isArray(type) ? type : [type];
  if (!types.some((one) => isOfType(one, value))) return false;
  if (isObject(value)) {
    if (Array.isArray(required) && required.some((key) => !(String(key) in value))) return false;
    if (
      isObject(properties) &&
      !Object.entries(properties).every(([key, one]) => !(key in value) || hasShape(one, value[key]))
    )
      return false;
  }
  const some = [oneOf, anyOf].filter(Array.isArray).every((all) => all.some((one) => hasShape(one, value)));
  return some && (!Array.isArray(allOf) || allOf.every((one) => hasShape(one, value)));
}

/** Decides nothing but which alternative is meant: whether settings are right is said by the driver when they are saved. */
export const validator: ValidatorType<unknown, RJSFSchema> = {
  validateFormData: () => ({ errors: [], errorSchema: {} }),
  isValid: (schema, value) => hasShape(schema, value),
  rawValidation: () => ({}),
};
