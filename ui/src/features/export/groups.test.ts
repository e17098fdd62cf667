import { describe, expect, it } from "vitest";
import type { FormatEntry } from "../../generated/responses";
import { beside, bytes, fileName, grouped } from "./groups";

const format = (id: string, given: Partial<FormatEntry> = {}): FormatEntry => ({
  id,
  name: id,
  extension: "txt",
  driver: null,
  of_machine: false,
  program: false,
  settings: {},
  settings_schema: {},
  ...given,
});

describe("grouped", () => {
  it("puts what the machine's own driver writes first, and every format into one group", () => {
    const all = [
      format("wirebend-kit-text", { driver: "wirebend-kit", of_machine: true, program: true }),
      format("svg", { of_machine: true }),
      format("lra-csv", { driver: "tables", of_machine: true, program: true }),
      format("template-pdf"),
      format("job-sheet"),
      format("obj-tube"),
      format("ybc-csv", { driver: "tables" }),
    ];
    const groups = grouped(all, "wirebend-kit").map(({ title, formats }) => [title, formats.map(({ id }) => id)]);
    expect(groups).toEqual([
      ["This machine", ["wirebend-kit-text"]],
      ["Templates and sheets", ["template-pdf", "job-sheet"]],
      ["Pictures and models", ["svg", "obj-tube"]],
      ["Tables and programs", ["lra-csv", "ybc-csv"]],
    ]);
  });

  it("leaves out groups without formats", () => {
    expect(grouped([format("svg")], null).map(({ title }) => title)).toEqual(["Pictures and models"]);
  });
});

describe("fileName", () => {
  it.each([
    ["bunny.wirebend", "gcode", "bunny.gcode"],
    ["My frame", "pdf", "My frame.pdf"],
    ["a/b: c", "svg", "a-b- c.svg"],
    ["", "obj", "design.obj"],
  ])("%s as %s is %s", (design, extension, name) => expect(fileName(design, { id: "gcode", extension })).toBe(name));

  it("keeps papers of one design apart", () => {
    const names = ["template-pdf", "job-sheet"].map((id) => fileName("hook.wirebend", { id, extension: "pdf" }));
    expect(names).toEqual(["hook-template.pdf", "hook-sheet.pdf"]);
  });
});

describe("beside", () => {
  it("stays in the folder", () => {
    expect(beside("/there/bunny.wirebend", "bunny.svg")).toBe("/there/bunny.svg");
    expect(beside("C:\\wires\\bunny.wirebend", "bunny.svg")).toBe("C:\\wires\\bunny.svg");
    expect(beside(null, "bunny.svg")).toBe("bunny.svg");
  });
});

describe("bytes", () => {
  it("is short", () => expect([512, 3400, 1_234_567].map(bytes)).toEqual(["512 B", "3.4 kB", "1.2 MB"]));
});
