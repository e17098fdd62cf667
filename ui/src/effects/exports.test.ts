// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
class Refused extends Error {
  constructor(readonly refusal: { code: string; kind: string; message: string }) {
    super(refusal.message);
  }
}
vi.mock("../platform", () => ({
  platform,
  get Refused() {
    return Refused;
  },
}));

import type { FormatEntry } from "../generated/responses";
import { type DesignState, useDesign } from "../state/design/design";
import { preview, setDespiteErrors, setSettings, useExports, write } from "../state/files/exports";
import { useFiles } from "../state/files/files";
import { useMachines } from "../state/machine/machines";
import { followDesign } from "./design";

const format = { id: "gcode", name: "G-code", extension: "gcode", settings: {} } as unknown as FormatEntry;
const written = { files: ["/there/a.gcode"], beginnings: [], bytes: [], notes: [], feasible: true };
const NOTHING = { despiteErrors: false, preview: null, previewing: false, written: null };

const elsewhere: readonly (readonly [string, () => void])[] = [
  ["another design", () => useFiles.setState(({ opened }) => ({ opened: opened + 1 }))],
  ["another machine", () => useDesign.setState({ state: { machine: "pensa" } as DesignState })],
  ["another profile of it", () => useMachines.setState(({ changes }) => ({ changes: changes + 1 }))],
];

let end = () => {};
beforeEach(() => {
  useDesign.setState({ state: { machine: "kit" } as DesignState });
  useExports.setState({ formats: [format], chosen: null });
  platform.ask.mockReset();
  platform.ask.mockResolvedValue(written);
  end = followDesign();
});
afterEach(() => end());

describe.each(elsewhere)("for %s", (_, go) => {
  it("nothing of what a person said of the one before is kept", async () => {
    setSettings("gcode", { decimals: 1 });
    setDespiteErrors(true);
    await preview();
    await write(format, "/there/a.gcode", false);
    expect(useExports.getState()).toMatchObject({ despiteErrors: true, written: { format: "gcode" } });
    go();
    expect(useExports.getState()).toMatchObject(NOTHING);
    expect(useExports.getState().settings.size).toBe(0);
  });

  it("an answer that was on its way is not shown", async () => {
    const answers: ((answer: unknown) => void)[] = [];
    platform.ask.mockImplementation(() => new Promise((answer) => answers.push(answer)));
    const both = [preview(), write(format, "/there/a.gcode", false)];
    go();
    for (const answer of answers) answer(written);
    await Promise.all(both);
    expect(useExports.getState()).toMatchObject(NOTHING);
  });
});

it("keeps what is said of a design while it is saved, and asks anew once it is drawn on or undone", () => {
  setDespiteErrors(true);
  setSettings("gcode", { decimals: 1 });
  const state = { machine: "kit", changed: true, stencils: [] as const, parts: [] as const } as unknown as DesignState;
  useDesign.setState({ state, vertices: new Map() });
  expect(useExports.getState().despiteErrors).toBe(true);
  useDesign.setState(({ version }) => ({ version: version + 1 }));
  expect(useExports.getState().despiteErrors).toBe(false);
  expect(useExports.getState().settings.size).toBe(1);
});

it("keeps with a file that it was not searched for collisions to its end", async () => {
  const message = "collisions not fully searched: 12 of 340 steps in 10 s";
  const notes = [{ code: "collisions-not-searched", count: 328, message }];
  platform.ask.mockResolvedValue({ ...written, notes });
  await write(format, "/there/a.gcode", false);
  expect(useExports.getState().written?.notSearched).toMatch(/^Collisions not fully searched: 12 of 340 steps/);
});
