// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), pickSave: vi.fn() }));
const openPages = vi.hoisted(() => vi.fn());
vi.mock("../../../platform", () => ({ platform, Refused: class Refused extends Error {} }));
vi.mock("./pdf", () => ({ openPages }));

import type { FormatEntry } from "../../../generated/responses";
import { place } from "../../../shared/testing";
import { useDesign } from "../../../state/design/design";
import { useExports } from "../../../state/files/exports";
import { designState } from "../../../state/testing";
import { useUnits } from "../../../state/window/units";
import { PrintPreview } from "./PrintPreview";

const at = place();
const format = {
  id: "job-sheet",
  name: "Job sheet (PDF)",
  extension: "pdf",
  driver: null,
  settings: {},
  settings_schema: { properties: { paper: {}, units: {} } },
} as unknown as FormatEntry;
const closed = vi.fn();
let closes = 0;
let drawn: number[];

beforeEach(() => {
  HTMLDialogElement.prototype.showModal ??= () => {};
  HTMLDialogElement.prototype.close ??= () => {};
  closed.mockReset();
  closes = 0;
  drawn = [];
  platform.ask.mockReset();
  platform.ask.mockImplementation(async (_: string, { output }: { output?: { path: string } }) =>
    output ? { files: [output.path], notes: [], contents: [] } : { files: [], contents: [btoa("%PDF-1.7")] },
  );
  platform.pickSave.mockReset();
  openPages.mockReset();
  openPages.mockImplementation(async () => ({
    sizes: [
      [210, 297],
      [210, 297],
    ],
    draw: (page: number) => {
      drawn.push(page);
      return () => {};
    },
    close: () => {
      closes += 1;
    },
  }));
  useUnits.setState({ unit: "mm" });
  useDesign.setState({ state: designState({ name: "house.wirebend" }) });
  useExports.setState({ formats: [format], chosen: "job-sheet", settings: new Map() });
});

const show = async () => {
  at.show(<PrintPreview format={format} onClose={closed} />);
  await settled();
};
/** What was asked for is there. */
const settled = () => act(() => new Promise((done) => setTimeout(done, 20)));
const text = () => at.host.textContent ?? "";
const button = (name: string) =>
  [...at.host.querySelectorAll("button")].find(
    (one) => one.textContent === name || one.getAttribute("aria-label") === name,
  );

it("shows the pages of the file that would be written, with its settings", async () => {
  useUnits.setState({ unit: "inch" });
  useExports.setState({ settings: new Map([["job-sheet", { paper: "letter" }]]) });
  await show();
  expect(text()).toContain("Page 1 of 2");
  expect(platform.ask).toHaveBeenCalledWith("export", {
    format: "job-sheet",
    settings: { paper: "letter", units: "in" },
    despite_errors: false,
    contents: true,
  });
  const [bytes] = openPages.mock.calls[0] ?? [];
  expect(new TextDecoder().decode(bytes)).toBe("%PDF-1.7");
  expect(at.host.querySelectorAll('[role="img"]').length).toBe(2);
  expect(drawn).toContain(0);
});

it("saves what is shown where the person says, and closes what it has opened", async () => {
  platform.pickSave.mockResolvedValue("/there/house-sheet.pdf");
  await show();
  expect(text()).toContain("Page 1 of 2");
  act(() => button("Save…")?.click());
  await settled();
  expect(text()).toContain("Written: /there/house-sheet.pdf");
  expect(platform.pickSave.mock.calls[0]?.[0]).toBe("house-sheet.pdf");
  const [, { settings, output }] = platform.ask.mock.calls.at(-1) as [string, { settings: object; output: object }];
  expect([settings, output]).toEqual([{ units: "mm" }, { path: "/there/house-sheet.pdf", force: true }]);
  act(() => button("Close")?.click());
  expect(closed).toHaveBeenCalledOnce();
  at.show(null);
  expect(closes).toBe(1);
});

it("writes nothing where the person chooses no file", async () => {
  platform.pickSave.mockResolvedValue(null);
  await show();
  expect(text()).toContain("Page 1 of 2");
  const asked = platform.ask.mock.calls.length;
  act(() => button("Save…")?.click());
  await settled();
  expect(platform.ask.mock.calls.length).toBe(asked);
});

it.each([
  ["the file", () => platform.ask.mockRejectedValue(new Error("the template takes more than 400 pages"))],
  ["the pages", () => openPages.mockRejectedValue(new Error("the template takes more than 400 pages"))],
])("says in a sentence why %s cannot be shown", async (_, fail) => {
  fail();
  await show();
  expect(text()).toContain("The pages cannot be shown");
  expect(text()).toContain("more than 400 pages");
  expect(button("Save…")?.getAttribute("aria-disabled")).toBe("true");
});

it("closes a file that was opened after the dialog", async () => {
  let open: (pages: object) => void = () => {};
  const made = { sizes: [], draw: () => () => {}, close: vi.fn() };
  openPages.mockImplementation(() => new Promise((answer) => (open = answer)));
  await show();
  expect(openPages).toHaveBeenCalled();
  at.show(null);
  open(made);
  await settled();
  expect(made.close).toHaveBeenCalledOnce();
});
