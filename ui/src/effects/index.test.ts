// @vitest-environment happy-dom
import { expect, it, vi } from "vitest";

/** What the platform is heard by, as long as it is. */
const heard = vi.hoisted(() => new Set<string>());
const platform = vi.hoisted(() => {
  const hears = (what: string) => () => {
    heard.add(what);
    return () => void heard.delete(what);
  };
  return {
    ask: vi.fn(async () => ({ problems: [], formats: [], wires: [] })),
    stop: vi.fn(async () => {}),
    setTitle: vi.fn(),
    listen: hears("told"),
    onDrop: hears("dropped"),
    onOpen: hears("opened"),
    onClose: hears("closed"),
  };
});
vi.mock("../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { Fix } from "../generated/responses";
import type { Played } from "../scene/interface";
import { useDesign } from "../state/design/design";
import { showFix, useFixes } from "../state/design/fixes/fixes";
import { useSelection } from "../state/design/selection";
import { setDespiteErrors, useExports } from "../state/files/exports";
import { useFiles } from "../state/files/files";
import { useFrame } from "../state/frame/frame";
import { useShape } from "../state/frame/shape";
import { useByHand } from "../state/machine/by_hand";
import { useMachines } from "../state/machine/machines";
import type { WireRun } from "../state/machine/operator";
import { useRun } from "../state/machine/run";
import { usePlayback, useProgram } from "../state/program/program";
import { useSequence } from "../state/sequence/sequence";
import { designState, machineState } from "../state/testing";
import { useUi } from "../state/window/ui";
import { useUnits } from "../state/window/units";
import { useView } from "../state/window/view";
import { start } from ".";

const nothing = { moved: [], doubled: [], gone_edges: [], new_edges: [], detached: [] };
const vertex = (id: number) => [id, { id, at: [id, 0, 0] as const, support: false }] as const;
const played: Played = {
  steps: [],
  designed: { corners: [], poses: [] },
  made: null,
  bodies: [],
  wireDiameter: 1,
  orbitOffset: 0,
  pegTop: 0,
};

const opens = () => useFiles.setState(({ opened }) => ({ opened: opened + 1 }));
const changes = () => useDesign.setState({ vertices: new Map([vertex(2)]), edges: new Map() });

/** What there is, what happens then, and what is to be seen of the effect. */
const EFFECTS: readonly (readonly [string, () => void, () => void, () => boolean])[] = [
  [
    "what a person said of an export is forgotten with the design",
    () => setDespiteErrors(true),
    opens,
    () => !useExports.getState().despiteErrors,
  ],
  [
    "so it is with the machine",
    () => setDespiteErrors(true),
    () => useDesign.setState({ state: designState({ machine: "other" }) }),
    () => !useExports.getState().despiteErrors,
  ],
  [
    "so it is with its profile",
    () => setDespiteErrors(true),
    () => useMachines.setState({ changes: 77 }),
    () => !useExports.getState().despiteErrors,
  ],
  [
    "what became of the last wire is forgotten",
    () => useRun.setState({ ended: { outcome: "made" } as WireRun }),
    opens,
    () => useRun.getState().ended === null,
  ],
  [
    "the program is forgotten",
    () => useProgram.setState({ problem: "none" }),
    opens,
    () => useProgram.getState().problem === null,
  ],
  [
    "nothing is selected in another design",
    () => useSelection.setState({ vertices: new Set([1]) }),
    opens,
    () => useSelection.getState().vertices.size === 0,
  ],
  [
    "what is gone is not selected",
    () => useSelection.setState({ vertices: new Set([1]) }),
    changes,
    () => useSelection.getState().vertices.size === 0,
  ],
  [
    "what was compared was another design",
    () => useMachines.setState({ compared: { machine: "a", asked: "bar", from: null, to: null, problem: null } }),
    changes,
    () => useMachines.getState().compared === null,
  ],
  [
    "a fix is not shown of another design",
    () => showFix({ preview: nothing } as unknown as Fix),
    changes,
    () => useFixes.getState().shown === null,
  ],
  [
    "a fix is not shown without its preview",
    () => showFix({ preview: nothing } as unknown as Fix),
    () => useView.setState({ preview: null }),
    () => useFixes.getState().shown === null,
  ],
  [
    "a program that is not the design's is not shown",
    () => usePlayback.setState({ played }),
    changes,
    () => usePlayback.getState().played === null,
  ],
  [
    "moves by hand give way to a design that is changed",
    () => useByHand.setState({ played }),
    changes,
    () => useByHand.getState().played === null,
  ],
  [
    "moves by hand give way to a program",
    () => useByHand.setState({ played }),
    () => usePlayback.setState({ played: { ...played } }),
    () => useByHand.getState().played === null,
  ],
  [
    "what was computed of a frame is forgotten",
    () => useFrame.setState({ problem: "none" }),
    opens,
    () => useFrame.getState().problem === null,
  ],
  [
    "a frame is not shown of another design",
    () => useShape.setState({ view: { kind: "loaded" } }),
    changes,
    () => useShape.getState().view === null,
  ],
  [
    "a frame gives way to a program",
    () => useShape.setState({ view: { kind: "loaded" } }),
    () => usePlayback.setState({ played: { ...played } }),
    () => useShape.getState().view === null,
  ],
  [
    "a click chooses a support while supports are picked",
    () => useFrame.setState({ picking: true, chosen: new Set() }),
    () => useSelection.setState({ vertices: new Set([2]) }),
    () => useFrame.getState().chosen.has(2),
  ],
  [
    "a mode that swings is drawn",
    () => useShape.setState({ view: { kind: "mode", mode: 0 } }),
    () => useShape.setState({ swinging: true }),
    () => vi.mocked(requestAnimationFrame).mock.calls.length > 0,
  ],
  [
    "what was found of a sequence is forgotten",
    () => useSequence.setState({ problem: "none" }),
    opens,
    () => useSequence.getState().problem === null,
  ],
  [
    "a sequence is not shown of another design",
    () => useSequence.setState({ shown: true }),
    changes,
    () => !useSequence.getState().shown,
  ],
  [
    "a sequence gives way to a frame",
    () => useSequence.setState({ shown: true }),
    () => useShape.setState({ view: { kind: "loaded" } }),
    () => !useSequence.getState().shown,
  ],
  [
    "a sequence that plays is drawn",
    () => useSequence.setState({ shown: true }),
    () => useSequence.setState({ playing: true }),
    () => vi.mocked(requestAnimationFrame).mock.calls.length > 0,
  ],
  [
    "the grid goes with the unit",
    () => useView.setState({ grid: 5 }),
    () => useUnits.setState({ unit: "inch" }),
    () => useView.getState().grid === 6.35,
  ],
  [
    "lengths are shown as the person has chosen",
    () => {},
    () => useUi.getState().setUnit("inch"),
    () => useUnits.getState().unit === "inch",
  ],
  [
    "the theme is shown",
    () => document.documentElement.removeAttribute("data-theme"),
    () => useUi.getState().setTheme("light"),
    () => document.documentElement.dataset.theme === "light",
  ],
  [
    "how the window stands is kept",
    () => localStorage.clear(),
    () => useUi.getState().setPanelWidth(444),
    () => (localStorage.getItem("wirebend.ui") ?? "").includes("444"),
  ],
  [
    "the title is the design's",
    () => platform.setTitle.mockClear(),
    () => useDesign.setState({ state: designState({ name: "House" }) }),
    () => platform.setTitle.mock.calls.length > 0,
  ],
  [
    "the checks ask a machine that was connected",
    () => platform.ask.mockClear(),
    () => useRun.setState({ state: machineState("ready") }),
    () => platform.ask.mock.calls.length > 0,
  ],
  [
    "keys of the window are heard",
    () => useUi.setState({ dialog: null }),
    () => void document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "?", bubbles: true })),
    () => useUi.getState().dialog === "keys",
  ],
  [
    "playing plays",
    () => usePlayback.setState({ played: { ...played, steps: [] } }),
    () => usePlayback.setState({ playing: true }),
    () => vi.mocked(requestAnimationFrame).mock.calls.length > 0,
  ],
];

/** As it is before each of them. */
function before(): void {
  vi.stubGlobal(
    "requestAnimationFrame",
    vi.fn(() => 1),
  );
  useUi.setState({ unit: null, theme: "dark", panelWidth: 400 });
  useUnits.setState({ unit: "mm" });
  useRun.setState({ state: null, ended: null });
  usePlayback.setState({ played: null, playing: false, live: false });
  useByHand.setState({ played: null });
  useMachines.setState({ changes: 0, compared: null });
  useView.setState({ preview: null });
  useSelection.setState({ vertices: new Set(), edges: new Set() });
  useFrame.setState({ picking: false, chosen: new Set(), problem: null });
  useShape.setState({ view: null, swinging: false });
  useSequence.setState({ shown: false, playing: false, problem: null });
  useDesign.setState({
    state: designState({ machine: "kit" }),
    vertices: new Map([vertex(1), vertex(2)]),
    edges: new Map(),
    check: null,
  });
}

it.each(EFFECTS)("%s, from the start to the end, and neither before nor after", async (_, there, happens, seen) => {
  const look = async () => {
    before();
    // What is on its way from before is over.
    await new Promise((over) => setTimeout(over));
    there();
    happens();
    return seen();
  };
  expect([await look(), heard.size]).toEqual([false, 0]);
  const end = start();
  const [happened, hears] = [await look(), [...heard].toSorted()];
  end();
  expect([happened, hears]).toEqual([true, ["closed", "dropped", "opened", "told"]]);
  expect([await look(), heard.size]).toEqual([false, 0]);
});
