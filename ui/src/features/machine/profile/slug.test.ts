import { describe, expect, it } from "vitest";
import { isSlug, slugOf, slugProblem } from "./slug";

describe("slugOf", () => {
  it.each([
    ["My bender", "my-bender"],
    ["Küche Nr. 2", "kuche-nr-2"],
    ["  Straße!  ", "strasse"],
    ["WireBend-kit (left)", "wirebend-kit-left"],
    ["線", ""],
  ])("%s is %s", (name, id) => expect(slugOf(name)).toBe(id));

  it("gives nothing but slugs", () => {
    for (const name of ["a--b", "-x-", "Ⅻ mm", "ÀÉÎ", "6061 T6"]) expect(isSlug(slugOf(name))).toBe(true);
  });
});

describe("slugProblem", () => {
  it("takes what is free, and says what else is wrong", () => {
    expect(slugProblem("my-kit", ["wirebend-kit"])).toBeNull();
    expect(slugProblem("", [])).toMatch(/Enter an id/);
    expect(slugProblem("My kit", [])).toMatch(/lower-case/);
    expect(slugProblem("a--b", [])).toMatch(/single hyphens/);
    expect(slugProblem("wirebend-kit", ["wirebend-kit"])).toMatch(/already/);
  });
});
