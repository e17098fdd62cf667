// Writes the TypeScript types of everything that the window asks and is told, from the JSON Schemas of the Rust side.
// With --check it writes nothing and fails where a file is stale.
import { readFileSync, writeFileSync } from "node:fs";
import { compile } from "json-schema-to-typescript";

const check = process.argv.includes("--check");
const banner = "/* Made by `make generate` from crates/app/schema. Do not edit. */";

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

let stale = 0;
for (const name of ["requests", "responses", "tells"]) {
  const schemaFile = new URL(`../../crates/app/schema/asks.${name}.schema.json`, import.meta.url);
  const schema = plain(JSON.parse(readFileSync(schemaFile, "utf8")));
  const text = await compile(schema, schema.title, { bannerComment: banner, unreachableDefinitions: false, additionalProperties: false, maxItems: 16 });
  const file = new URL(`../src/generated/${name}.ts`, import.meta.url);
  if (!check) {
    writeFileSync(file, text);
  } else if (readFileSync(file, "utf8") !== text) {
    console.error(`ui/src/generated/${name}.ts is stale: run \`make generate\` and commit what it writes`);
    stale += 1;
  }
}
process.exit(stale ? 1 : 0);
