import { describe, expect, it } from "vitest";
import { formSchema, worded } from "./schema";

describe("worded", () => {
  it.each([
    ["bend_rate_deg_per_s", "Bend rate", "°/s"],
    ["feed_acceleration_mm_per_s2", "Feed acceleration", "mm/s²"],
    ["bend_units_per_deg", "Bend units", "per °"],
    ["margin_percent", "Margin", "%"],
    ["boot_s", "Boot", "s"],
    ["baud", "Baud", ""],
    ["mm", "Mm", ""],
    ["pin_out", "Pin out", ""],
  ])("%s is %s in %s", (key, title, unit) => expect(worded(key)).toEqual({ title, unit }));
});

describe("formSchema", () => {
  const schema = {
    $defs: {
      Case: {
        oneOf: [
          { const: "upper", description: "FEED", type: "string" },
          {
            const: "as-they-are",
            description: "As they are in the file, which is not changed in any way.",
            type: "string",
          },
        ],
      },
      Letter: { enum: ["X", "Y"], type: "string" },
      Tree: { type: "object", properties: { more: { $ref: "#/$defs/Tree" } } },
    },
    type: "object",
    description: "How scripts are written.",
    properties: {
      case: { $ref: "#/$defs/Case", default: "upper", description: "How commands are spelled." },
      mark: { anyOf: [{ $ref: "#/$defs/Letter" }, { type: "null" }], default: null },
      header: { type: ["boolean", "null"], default: null },
      decimals: { type: ["integer", "null"], minimum: 0, maximum: 9, default: null },
      pin_out: { type: "array", items: { type: "string" }, default: ["M5"] },
      paper: { title: "Paper", type: "string" },
      tree: { $ref: "#/$defs/Tree" },
    },
  };
  const properties = formSchema(schema).properties as Record<string, Record<string, unknown>>;

  it("follows references and keeps what is said where they are", () => {
    expect(properties.case).toMatchObject({
      title: "Case",
      default: "upper",
      description: "How commands are spelled.",
    });
    expect(properties.case?.oneOf).toEqual([
      { const: "upper", title: "upper · FEED" },
      { const: "as-they-are", title: "as they are" },
    ]);
  });

  it("makes a choice of what may be left open", () => {
    expect(properties.mark?.oneOf).toEqual([
      { const: null, title: "not set" },
      { const: "X", title: "X" },
      { const: "Y", title: "Y" },
    ]);
    expect(properties.header?.oneOf).toHaveLength(3);
    // Without a type the form shows the schema itself instead of a field.
    expect([properties.mark, properties.header, properties.case].map((one) => one?.type)).toEqual([
      "string",
      "string",
      "string",
    ]);
    expect(properties.decimals).toMatchObject({ type: "integer", nullable: true, minimum: 0, maximum: 9 });
    expect(properties.decimals).not.toHaveProperty("default");
  });

  it("leaves lists and given titles as they are, and ends where a schema refers to itself", () => {
    expect(properties.pin_out).toMatchObject({ type: "array", items: { type: "string" }, default: ["M5"] });
    expect(properties.paper?.title).toBe("Paper");
    expect(JSON.stringify(properties.tree).length).toBeLessThan(1000);
  });

  it("has no fields for what is no schema", () => {
    expect(formSchema(null).properties).toBeUndefined();
  });
});
