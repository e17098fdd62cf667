/** The JSON Schema of a driver's settings as the form wants it: nothing referred to elsewhere, words for people. */

import type { RJSFSchema } from "@rjsf/utils";

type Schema = Record<string, unknown>;

/** A schema that refers to itself is cut off here. */
const DEEPEST = 6;

const isObject = (value: unknown): value is Schema =>
  typeof value === "object" && value !== null && !Array.isArray(value);
const listed = (value: unknown): Schema[] => (Array.isArray(value) ? value.filter(isObject) : []);
const isNull = (schema: Schema): boolean => schema.type === "null";

/** Units at the end of a key, longest first, and how they are written. */
const UNITS: readonly (readonly [string, string])[] = [
  ["_deg_per_s2", "°/s²"],
  ["_mm_per_s2", "mm/s²"],
  ["_deg_per_min", "°/min"],
  ["_mm_per_min", "mm/min"],
  ["_deg_per_s", "°/s"],
  ["_mm_per_s", "mm/s"],
  ["_per_deg", "per °"],
  ["_per_mm", "per mm"],
  ["_per_turn", "per turn"],
  ["_percent", "%"],
  ["_deg", "°"],
  ["_mm", "mm"],
  ["_us", "µs"],
  ["_ms", "ms"],
  ["_s", "s"],
];

/** "bend_rate_deg_per_s" is "Bend rate" in "°/s". */
export function worded(key: string): { readonly title: string; readonly unit: string } {
  const [end, unit] = UNITS.find(([suffix]) => key.endsWith(suffix) && key.length > suffix.length) ?? ["", ""];
  const words = key
    .slice(0, key.length - end.length)
    .replace(/[_-]+/g, " ")
    .trim();
  return { title: words.charAt(0).toUpperCase() + words.slice(1), unit };
}

/** The schema of an object as the form wants it. What cannot be understood is left as it is. */
export function formSchema(schema: unknown): RJSFSchema {
  const root = isObject(schema) ? schema : {};
  return { ...(prepared(root, root, 0) as RJSFSchema), title: "", description: "" };
}

function resolved(schema: Schema, root: Schema): Schema {
  const reference = schema.$ref;
  if (typeof reference !== "string") return schema;
  const { $ref: _, ...own } = schema;
  const path = reference.replace(/^#\//, "").split("/");
  const target = path.reduce<unknown>((at, part) => (isObject(at) ? at[part] : undefined), root);
  return isObject(target) ? { ...target, ...own } : own;
}

function prepared(given: Schema, root: Schema, depth: number): Schema {
  if (depth > DEEPEST) return {};
  let schema = resolved(given, root);
  let nullable = false;
  const choices = listed(schema.anyOf);
  const real = choices.filter((choice) => !isNull(choice));
  const [only] = real;
  if (choices.length > real.length && real.length === 1 && only) {
    nullable = true;
    const { anyOf: _, ...own } = schema;
    schema = { ...resolved(only, root), ...own };
  }
  const { type } = schema;
  if (Array.isArray(type) && type.includes("null")) {
    nullable = true;
    const rest = type.filter((one) => one !== "null");
    schema = { ...schema, type: rest.length === 1 ? rest[0] : rest };
  }
  const consts = constants(schema, nullable);
  if (consts) {
    const { enum: _, type: __, ...own } = schema;
    // The form goes by a type; whatever the values are, they are chosen by their words.
    return { ...own, type: "string", oneOf: consts };
  }
  const result: Schema = { ...schema };
  delete result.$defs;
  if (nullable) {
    result.nullable = true;
    if (result.default === null) delete result.default;
  }
  const { properties, items, additionalProperties } = schema;
  if (isObject(properties)) {
    result.properties = Object.fromEntries(
      Object.entries(properties).map(([key, property]) => {
        const one = isObject(property) ? prepared(property, root, depth + 1) : {};
        return [key, { ...one, title: typeof one.title === "string" ? one.title : worded(key).title }];
      }),
    );
  }
  if (isObject(items)) result.items = prepared(items, root, depth + 1);
  if (isObject(additionalProperties)) result.additionalProperties = prepared(additionalProperties, root, depth + 1);
  return result;
}

/** What a choice is called: its own word, with what it means where that is short. */
function choice(value: unknown, description: unknown): Schema {
  const word = typeof value === "string" ? value.replaceAll("-", " ") : String(value);
  const short = typeof description === "string" && description.length <= 28 ? description.replace(/\.$/, "") : "";
  return { const: value, title: short === "" ? word : `${word} · ${short}` };
}

/** The values to choose from; null where there are none to choose from. */
function constants(schema: Schema, nullable: boolean): Schema[] | null {
  const none: Schema[] = nullable ? [{ const: null, title: "not set" }] : [];
  if (Array.isArray(schema.enum)) return [...none, ...schema.enum.map((value) => choice(value, null))];
  const choices = listed(schema.oneOf);
  if (choices.length > 0 && choices.every((one) => "const" in one))
    return [...none, ...choices.map((one) => choice(one.const, one.description))];
  if (schema.type === "boolean" && nullable) {
    return [...none, { const: true, title: "yes" }, { const: false, title: "no" }];
  }
  return null;
}
