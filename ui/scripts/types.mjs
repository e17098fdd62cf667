// Writes the TypeScript types of everything that the window asks and is told, from the JSON Schemas of the Rust side.
// With --check it writes nothing and fails where a file is stale.
import { readFileSync, writeFileSync } from "node:fs";
import { compile } from "json-schema-to-typescript";

const check = process.argv.includes("--check");
const banner = "/* Made by `make generate` from crates/api/schema. Do not edit. */";

// A reference with a description beside it would be written out as a type of its own each time; with more beside it, it is
// both.
function plain(value) {
  if (Array.isArray(value)) return value.map(plain);
  if (value === null || typeof value !== "object") return value;
  if (typeof value.$ref === "string") {
    const { $ref, description: _, ...rest } = value;
    return Object.keys(rest).length === 0 ? { $ref } : { allOf: [{ $ref }, plain(rest)] };
  }
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, plain(inner)]));
}

const read = (name) =>
  plain(JSON.parse(readFileSync(new URL(`../../crates/api/schema/${name}.schema.json`, import.meta.url), "utf8")));

// Several schemas as one, each a definition beside those that they have in common: a type is written once.
function together(title, names) {
  const schemas = names.map((name) => read(`asks.${name}`));
  const $defs = { ...read("common").$defs };
  for (const { $defs: own, $schema: _, ...schema } of schemas) Object.assign($defs, own, { [schema.title]: schema });
  const properties = Object.fromEntries(schemas.map((schema, at) => [names[at], { $ref: `#/$defs/${schema.title}` }]));
  const text = JSON.stringify({ title, type: "object", properties, required: names, $defs });
  return JSON.parse(text.replaceAll("common.schema.json#", "#"));
}

let stale = 0;
for (const [module, names] of [
  ["requests", ["requests"]],
  ["responses", ["responses", "events"]],
]) {
  const text = await compile(together("All", names), "All", {
    bannerComment: banner,
    unreachableDefinitions: false,
    additionalProperties: false,
    maxItems: 16,
  });
  const file = new URL(`../src/generated/${module}.ts`, import.meta.url);
  if (!check) {
    writeFileSync(file, text);
  } else if (readFileSync(file, "utf8") !== text) {
    console.error(`ui/src/generated/${module}.ts is stale: run \`make generate\` and commit what it writes`);
    stale += 1;
  }
}
process.exit(stale ? 1 : 0);
