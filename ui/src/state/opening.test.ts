// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const nothing = () => () => {};
const platform = vi.hoisted(() => ({
  ask: vi.fn(),
  stop: vi.fn(),
  listen: vi.fn(),
  onDrop: vi.fn(),
  onOpen: vi.fn(),
  filesToOpen: vi.fn(),
  onClose: vi.fn(),
  setTitle: vi.fn(),
}));
vi.mock("../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { useUnitStore } from "../shared/unit";
import { type DesignState, useDesign } from "./design";
import { begun, open } from "./opening";
import { useUi } from "./ui";

let end = () => {};
beforeEach(() => {
  for (const mock of [platform.listen, platform.onDrop, platform.onOpen, platform.onClose]) mock.mockImplementation(nothing);
  platform.filesToOpen.mockResolvedValue([]);
  platform.ask.mockRejectedValue(new Error("nobody is there"));
  useUi.setState({ unit: null });
  useDesign.setState({ state: null });
  end = open();
});
afterEach(() => end());

describe("what the window begins with", () => {
  it("is waited for, the files that it was started with too", async () => {
    end();
    let name: (paths: string[]) => void = () => {};
    platform.filesToOpen.mockReturnValue(new Promise((resolve) => (name = resolve)));
    end = open();
    let there = false;
    const waited = begun().then(() => (there = true));
    await Promise.resolve();
    name(["/there/bunny.wirebend"]);
    expect(there).toBe(false);
    await waited;
    expect(platform.ask.mock.calls.map(([name]) => name)).toEqual(expect.arrayContaining(["start", "look"]));
  });

  it("is not waited for for long", async () => {
    end();
    platform.filesToOpen.mockReturnValue(new Promise(() => {}));
    end = open();
    await begun();
  });
});

const show = (units: DesignState["units"]) => useDesign.setState({ state: { units, name: "" } as DesignState });

describe("lengths", () => {
  it("are shown as the design says, as long as the person has not chosen", () => {
    show("inch");
    expect(useUnitStore.getState().unit).toBe("inch");
    show("mm");
    expect(useUnitStore.getState().unit).toBe("mm");
  });

  it("stay as the person has chosen, whatever is opened", () => {
    show("mm");
    useUi.getState().setUnit("inch");
    expect(useUnitStore.getState().unit).toBe("inch");
    show("mm");
    expect(useUnitStore.getState().unit).toBe("inch");
  });
});
