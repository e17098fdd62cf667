// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({
  ask: vi.fn(),
  stop: vi.fn(async () => {}),
  listen: vi.fn(),
  pickSave: vi.fn(async (): Promise<string | null> => "/there/moves.wbmoves"),
}));
vi.mock("../../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../../shared/testing";
import type { MachineState } from "../../../state/machine/operator";
import { useRun } from "../../../state/machine/run";
import { machineState } from "../../../state/testing";
import { Recording } from "./Recording";

const at = place();

beforeEach(() => {
  platform.ask.mockReset().mockReturnValue(new Promise(() => {}));
  useRun.setState({ recorded: [{ move: "feed", mm: 10 }] });
});

const replay = () => [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Replay");
const orders = (): unknown[] =>
  platform.ask.mock.calls.filter(([name]) => name === "order").map(([, { request }]) => request);

it.each<readonly [string, MachineState]>([
  ["a machine", machineState("ready", "jog", "replay")],
  ["a simulation", { ...machineState("ready", "jog", "replay"), simulated: true }],
])(
  "replays on %s by the order that asks a person before anything moves: moves by hand may go without a question",
  (_, state) => {
    at.show(<Recording state={state} record={false} />);
    act(() => replay()?.click());
    expect(orders()).toEqual([{ order: "replay", file: null }]);
  },
);

it("does not replay where the machine takes no replay, although it could be moved by hand", () => {
  at.show(<Recording state={machineState("ready", "jog")} record={false} />);
  expect(replay()?.getAttribute("aria-disabled")).toBe("true");
  act(() => replay()?.click());
  expect(orders()).toEqual([]);
});

describe("making a design of what was just recorded", () => {
  const press = async () => {
    at.show(<Recording state={machineState("ready", "jog", "replay")} record={false} />);
    await act(async () =>
      [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Make it a design…")?.click(),
    );
    return platform.ask.mock.calls.filter(([name]) => name !== "window").map(([name, asked]) => [name, asked]);
  };
  beforeEach(() => {
    platform.ask.mockImplementation((name: string) =>
      name === "save-recording" ? Promise.resolve({ file: "/there/moves.wbmoves" }) : new Promise(() => {}),
    );
  });

  it("saves the moves, and opens the file that they are in", async () => {
    expect(await press()).toEqual([
      ["save-recording", { output: { path: "/there/moves.wbmoves", force: true } }],
      ["look", { design: { input: { file: "/there/moves.wbmoves" } } }],
    ]);
  });

  it("opens nothing where no file is chosen", async () => {
    platform.pickSave.mockResolvedValueOnce(null);
    expect(await press()).toEqual([]);
  });
});
