import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { type FieldGroup, MACHINE_GROUPS, MATERIAL_GROUPS } from "./fields";

interface Schema {
  readonly $ref?: string;
  readonly anyOf?: readonly Schema[];
  readonly properties?: Readonly<Record<string, Schema>>;
  readonly $defs?: Readonly<Record<string, Schema>>;
}

/** The keys of all figures with a source that a schema of profiles has. */
function figures(kind: string): string[] {
  const file = new URL(`../../../../../machine-profiles/schema/${kind}.schema.json`, import.meta.url);
  const schema = JSON.parse(readFileSync(file, "utf8")) as Schema;
  const meant = (part: Schema): Schema => {
    const one = part.anyOf?.find(({ $ref }) => $ref) ?? part;
    return one.$ref ? meant(schema.$defs?.[one.$ref.replace("#/$defs/", "")] ?? {}) : one;
  };
  const below = (part: Schema, path: string): string[] =>
    Object.entries(meant(part).properties ?? {}).flatMap(([key, value]) => {
      const at = path ? `${path}.${key}` : key;
      const { properties } = meant(value);
      return properties?.value && properties.source ? [at] : below(value, at);
    });
  return below(schema, "");
}

const keys = (groups: readonly FieldGroup[]) => groups.flatMap(({ fields }) => fields.map(({ key }) => key));

it.each([
  ["machine", MACHINE_GROUPS],
  ["material", MATERIAL_GROUPS],
] as const)("shows every figure of a %s: one that is missing could be changed by hand alone", (kind, groups) => {
  const wanted = figures(kind);
  expect(wanted.length).toBeGreaterThan(5);
  expect(wanted.filter((key) => !keys(groups).includes(key) && !key.startsWith("springback."))).toEqual([]);
  expect(new Set(keys(groups)).size).toBe(keys(groups).length);
});
