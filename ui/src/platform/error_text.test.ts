import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import type { ErrorRemedy } from "../generated/responses";
import { errorText, remedyText } from "./error_text";

type Schema = {
  readonly const?: string;
  readonly enum?: readonly string[];
  readonly type?: string | readonly string[];
  readonly $ref?: string;
  readonly anyOf?: readonly Schema[];
  readonly oneOf?: readonly Schema[];
  readonly items?: Schema;
  readonly properties?: Readonly<Record<string, Schema>>;
};

const SCHEMA = JSON.parse(
  readFileSync(new URL("../../../crates/api/schema/common.schema.json", import.meta.url), "utf8"),
) as { readonly $defs: Readonly<Record<string, Schema>> };

/** A value that the schema allows. */
function sample(schema: Schema): unknown {
  if (schema.const !== undefined) return schema.const;
  if (schema.enum) return schema.enum[0];
  if (schema.$ref) return sample(SCHEMA.$defs[schema.$ref.replace("#/$defs/", "")] ?? {});
  const first = schema.anyOf?.[0] ?? schema.oneOf?.[0];
  if (first) return sample(first);
  const type = typeof schema.type === "string" ? schema.type : schema.type?.[0];
  switch (type) {
    case "object":
      return Object.fromEntries(Object.entries(schema.properties ?? {}).map(([key, inner]) => [key, sample(inner)]));
    case "array":
      return [sample(schema.items ?? {})];
    case "boolean":
      return false;
    case "integer":
    case "number":
      return 1;
    default:
      return "some text";
  }
}

const ALL = (SCHEMA.$defs.ErrorRemedy?.oneOf ?? []).map((variant) => sample(variant) as ErrorRemedy);

describe("remedyText", () => {
  it("knows of remedies", () => {
    expect(ALL.length).toBeGreaterThan(50);
  });

  it.each(ALL.map((remedy) => [remedy.remedy, remedy] as const))(
    "words %s for the window, without an option or a command",
    (_, remedy) => {
      const text = remedyText(remedy);
      expect(text).not.toMatch(/--[a-z]|`|wirebend/);
      // One that only a command line has is not worded here.
      if (remedy.remedy !== "name-runs-folder") expect(text).toMatch(/^[A-Z].*[.?]$/);
    },
  );
});

describe("errorText", () => {
  it("states the fact, then what to do", () => {
    const remedies: ErrorRemedy[] = [
      { remedy: "choose-other-file" },
      { remedy: "overwrite", path: "/there/house.txt" },
    ];
    expect(errorText({ message: "/there/house.txt exists already", remedies })).toBe(
      "/there/house.txt exists already. Choose another name. Or confirm that it may be replaced.",
    );
  });

  it("keeps the settings that differ beside what to do about them", () => {
    const message =
      "the machine is not set as the profile of 'kit' says, and wires would come out wrong: feed is 3, not 4";
    const remedies: ErrorRemedy[] = [
      { remedy: "write-settings", machine: "kit", port: "p" },
      { remedy: "accept-settings" },
    ];
    expect(errorText({ message, remedies })).toBe(
      "The machine is not set as the profile of 'kit' says, and wires would come out wrong: feed is 3, not 4. Write the settings of the profile to the machine in Run. Or confirm in Run that wires are bent anyway.",
    );
  });

  it("passes the advice of a driver through as a sentence", () => {
    const remedies: ErrorRemedy[] = [{ remedy: "follow-driver", advice: "close the serial monitor" }];
    expect(errorText({ message: "the port is busy", remedies })).toBe("The port is busy. Close the serial monitor.");
  });

  it("leaves a message without remedies as it is, but for a capital where no name of a file begins it", () => {
    expect(errorText({ message: "line 3 of a.obj: 'x' is no number" })).toBe("Line 3 of a.obj: 'x' is no number");
    expect(errorText({ message: "a.obj, line 3: 'x' is no number" })).toBe("a.obj, line 3: 'x' is no number");
    expect(errorText({ message: "cube: it cannot be read" })).toBe("cube: it cannot be read");
    expect(errorText({ message: "/x is damaged", remedies: [] })).toBe("/x is damaged");
  });
});
