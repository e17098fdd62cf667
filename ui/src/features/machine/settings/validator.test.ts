import { describe, expect, it } from "vitest";
import { hasShape } from "./validator";

describe("hasShape", () => {
  it.each([
    [{ const: "upper" }, "upper", true],
    [{ const: "upper" }, "lower", false],
    [{ const: null }, undefined, true],
    [{ enum: ["X", "Y"] }, "Z", false],
    [{ type: "integer" }, 3, true],
    [{ type: "integer" }, 3.5, false],
    [{ type: ["number", "null"] }, null, true],
    [{ type: "string" }, 3, false],
    [{ type: "array" }, [], true],
    [{ type: "object", required: ["a"] }, {}, false],
    [{ type: "object", properties: { a: { type: "string" } } }, { a: 1 }, false],
    [{ anyOf: [{ type: "string" }, { type: "null" }] }, 1, false],
    [{ allOf: [{ type: "number" }, { const: 2 }] }, 2, true],
    [false, 1, false],
    [{}, { anything: true }, true],
  ])("%j and %j: %s", (schema, value, fits) => expect(hasShape(schema, value)).toBe(fits));
});
