import { expect, it } from "vitest";
import { depthOf, elsewhereOf, hitOf } from "./hits";

const finding = { code: "meets_machine" as const, severity: "error" as const, body: "head", message: "", help: "" };
const contact = { step: 4, body: 2, finding, depth_mm: 2.13, later: 0, estimated: false };

it("names the step as it is counted and the body as its profile does", () => {
  expect(hitOf(contact)).toBe("Step 5 hits the head");
  expect(hitOf({ ...contact, body: null })).toBe("Step 5: the wire hits itself");
  expect(hitOf({ ...contact, depth_mm: -0.4 })).toBe("Step 5 comes near the head");
  expect(hitOf({ ...contact, body: null, depth_mm: -0.4 })).toBe("Step 5: the wire comes near itself");
});

it("says how deep it is, whether it comes again, and what is only an estimate", () => {
  expect(depthOf(contact, "mm")).toBe("2.1 mm deep");
  expect(depthOf({ ...contact, depth_mm: -0.42 }, "mm")).toBe("within 0.4 mm");
  expect(depthOf({ ...contact, depth_mm: 0.01 }, "mm")).toBe("less than 0.1 mm deep");
  expect(depthOf({ ...contact, depth_mm: -0.01 }, "inch")).toBe("within 0.001 in");
  expect(depthOf({ ...contact, later: 1, estimated: true }, "mm")).toBe("2.1 mm deep, in 1 more step; estimate");
  expect(depthOf({ ...contact, later: 12 }, "inch")).toBe("0.084 in deep, in 12 more steps");
});

it("counts what other wires hit, and apart from it what they only come near", () => {
  expect(elsewhereOf({ hits: 0, near: 0 })).toBeNull();
  expect(elsewhereOf({ hits: 1, near: 0 })).toBe("1 collision, of other wires");
  expect(elsewhereOf({ hits: 0, near: 3 })).toBe("3 places nearer than the clearance, of other wires");
  expect(elsewhereOf({ hits: 2, near: 1 })).toBe("2 collisions and 1 place nearer than the clearance, of other wires");
});
