// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const [ask, pickFile, pickSave] = vi.hoisted(() => [vi.fn(), vi.fn(), vi.fn()]);
vi.mock("../../platform", () => ({
  platform: { ask, pickFile, pickSave },
  Refused: class Refused extends Error {},
}));

import { place } from "../../shared/testing";
import { useProblems } from "../../state/asking/problems";
import { useDesign } from "../../state/design/design";
import { useFrame } from "../../state/frame/frame";
import { smallFrame } from "../../state/frame/testing";
import { chooseBuilder, forgetSequence, moveStep, useSequence } from "../../state/sequence/sequence";
import { sequenceChecked, sequenceDrawn } from "../../state/sequence/testing";
import { designState } from "../../state/testing";
import { useUi } from "../../state/window/ui";
import { Timeline } from "../timeline/Timeline";
import { SequenceSection } from "./SequenceSection";

const at = place();

beforeEach(() => {
  for (const mock of [ask, pickFile, pickSave]) mock.mockReset();
  ask.mockResolvedValue(sequenceDrawn());
  forgetSequence();
  useSequence.setState({ machine: null, layers: false, saving: false });
  useProblems.setState({ problems: [] });
  useFrame.setState({
    choices: { errors: [], strut_builders: [{ id: "builder", name: "A builder", default_material: "abs" }] },
  });
  useUi.setState({ open: ["sequence"] });
  useDesign.setState({ ...smallFrame(), state: designState(), version: 1 });
});

const button = (name: string) =>
  [...at.host.querySelectorAll("button")].find(
    (one) => one.textContent === name || one.getAttribute("aria-label") === name,
  );
const press = (name: string) => act(async () => button(name)?.click());

it("finds a sequence with the material of the machine, and steps through it on the timeline", async () => {
  at.show(
    <>
      <SequenceSection />
      <Timeline />
    </>,
  );
  await press("Find");
  expect(ask).toHaveBeenCalledWith("sequence", {
    machine: "builder",
    material: "abs",
    epsilon_mm: null,
    group_by: "edge",
  });
  expect(at.host.textContent).toContain("Largest sag0.2 mm of 0.65 mm");
  expect(at.host.textContent).toContain("step 2 / 2 · edge 1");
  await press("Step back");
  expect(useSequence.getState().at).toBe(1);
  await press("Back to the design");
  expect(at.host.textContent).not.toContain("step 2 / 2 · edge 1");
});

it("asks before a search replaces an order that was changed by hand, and only then", async () => {
  HTMLDialogElement.prototype.showModal ??= () => {};
  at.show(<SequenceSection />);
  await press("Find");
  await press("Find");
  expect(ask).toHaveBeenCalledTimes(2);
  ask.mockResolvedValue(sequenceDrawn([1, 0]));
  await press("Earlier");
  expect(ask).toHaveBeenCalledTimes(3);
  const { changed } = useSequence.getState();
  expect(changed).not.toBeNull();
  await press("Find");
  expect(at.host.querySelector("dialog")?.textContent).toContain("You changed the order by hand.");
  await press("Cancel");
  expect(at.host.querySelector("dialog")).toBeNull();
  expect([ask.mock.calls.length, useSequence.getState().changed]).toEqual([3, changed]);
  await press("Find");
  await press("Replace and find");
  expect([ask.mock.calls.length, useSequence.getState().changed]).toEqual([4, null]);
  expect(at.host.querySelector("dialog")).toBeNull();
});

it("says what is wrong with an order of one's own, and takes it back", async () => {
  at.show(<SequenceSection />);
  await press("Find");
  const wrong = sequenceDrawn([1, 0]);
  ask.mockResolvedValue({
    ...wrong,
    sequence: {
      ...wrong.sequence,
      feasible: false,
      diagnostics: [
        {
          code: "strut_floating",
          severity: "error",
          message: "edge 1 hangs on nothing",
          help: "build it later",
          step: 0,
        },
      ],
    },
  });
  await press("Earlier");
  expect(at.host.textContent).toContain("Your order cannot be built");
  expect(at.host.textContent).toContain("Edge 1 hangs on nothing");
  await press("Take back");
  expect(at.host.textContent).not.toContain("Edge 1 hangs on nothing");
});

it("tells how far a search is, and cancels it", async () => {
  ask.mockReturnValue(new Promise(() => {}));
  at.show(<SequenceSection />);
  await press("Find");
  expect(at.host.textContent).toContain("looking for a sequence…");
  await press("Cancel");
  expect(ask).toHaveBeenLastCalledWith("stop-sequence", {});
  expect(at.host.textContent).toContain("Cancelled.");
});

it("lets no step be moved while a sequence is looked for", async () => {
  at.show(<SequenceSection />);
  await press("Find");
  ask.mockReturnValue(new Promise(() => {}));
  await press("Find");
  expect(button("Earlier")?.title).toBe("A sequence is being looked for.");
  expect(at.host.querySelector("[role=option]")?.getAttribute("draggable")).toBe("false");
});

it("does not take a refusal for a frame that cannot be built", async () => {
  ask.mockRejectedValue(new Error("no such machine"));
  at.show(<SequenceSection />);
  await press("Find");
  expect(at.host.textContent).toContain("The sequence was not found");
  expect(at.host.textContent).toMatch(/no such machine/i);
});

it("keeps a sequence whose new order could not be checked", async () => {
  at.show(<SequenceSection />);
  await press("Find");
  ask.mockRejectedValue(new Error("no such machine"));
  await press("Earlier");
  expect(at.host.textContent).toContain("The sequence was not checked");
  expect(at.host.textContent).toContain("Largest sag");
});

it("names of a wire how many edges more it has, of a rod its edge alone", async () => {
  const drawn = sequenceDrawn();
  const [rod, wire] = drawn.sequence.steps;
  if (!rod || !wire) throw new Error("there are no steps");
  const steps = [
    { ...rod, edges: [0] },
    { ...wire, edges: [1, 5, 6] },
  ];
  ask.mockResolvedValue({ ...drawn, sequence: { ...drawn.sequence, steps } });
  at.show(<SequenceSection />);
  await press("Find");
  const named = [...at.host.querySelectorAll("[role=option]")].map((row) => row.children[1]?.textContent);
  expect(named).toEqual(["0", "1 +2"]);
});

it("keeps the sequence that is shown in a file, and checks one from a file", async () => {
  at.show(<SequenceSection />);
  await press("Find");
  pickSave.mockResolvedValue("/there/sequence.json");
  await press("Save sequence…");
  const steps = sequenceDrawn().sequence.steps;
  expect(ask).toHaveBeenLastCalledWith(
    "sequence",
    expect.objectContaining({
      order: steps.map(({ edge, from_vertex, direction }) => ({ edge, edges: [], from_vertex, direction })),
      output: { path: "/there/sequence.json", force: true },
      format: "wirebend",
    }),
  );
  pickFile.mockResolvedValue("/there/sequence.json");
  await press("Open…");
  expect(ask).toHaveBeenLastCalledWith("sequence", expect.objectContaining({ file: "/there/sequence.json" }));
});

it("says of each step of a file whether the head can stand: in how many directions was not counted", async () => {
  at.show(<SequenceSection />);
  const free = () => [...at.host.querySelectorAll("[role=option]")].map((row) => row.children[3]?.textContent);
  await press("Find");
  expect(free()).toEqual(["2", "2"]);
  pickFile.mockResolvedValue("/there/sequence.json");
  ask.mockResolvedValue(sequenceChecked());
  await press("Open…");
  expect(free()).toEqual(["yes", "yes"]);
});

it("does not save a sequence that cannot be built", async () => {
  const drawn = sequenceDrawn();
  ask.mockResolvedValue({ ...drawn, sequence: { ...drawn.sequence, feasible: false } });
  at.show(<SequenceSection />);
  await press("Find");
  await press("Save sequence…");
  expect(pickSave).not.toHaveBeenCalled();
});

it("keeps what was found where a file has no sequence", async () => {
  at.show(<SequenceSection />);
  await press("Find");
  const { found } = useSequence.getState();
  pickFile.mockResolvedValue("/there/readme.json");
  let refuse: (error: Error) => void = () => {};
  ask.mockImplementation(() => new Promise((_, reject) => (refuse = reject)));
  await press("Open…");
  expect(at.host.textContent).toContain("checking the sequence…");
  await act(async () => refuse(new Error("readme.json: there are no steps")));
  expect(useSequence.getState().found).toBe(found);
  expect(at.host.textContent).toContain("readme.json: there are no steps");
});

it("says of a file that could not be read, before anything is found, that its sequence was not checked", async () => {
  at.show(<SequenceSection />);
  pickFile.mockResolvedValue("/there/readme.json");
  ask.mockRejectedValue(new Error("readme.json: there are no steps"));
  await press("Open…");
  expect(at.host.querySelector("h2")?.textContent).toContain("not checked");
  expect(at.host.textContent).toContain("The sequence was not checked");
  expect(at.host.textContent).not.toContain("not found");
});

/** A dialog of files, which answers when the test says so: the window goes on behind it. */
function dialogOf(pick: typeof pickFile): (path: string) => Promise<void> {
  let choose = (_: string) => {};
  pick.mockReturnValue(new Promise((resolve) => (choose = resolve)));
  return (path) => act(async () => choose(path));
}
const said = () => useProblems.getState().problems.map(({ message }) => message);

it("asks before a file replaces an order that was changed by hand, also behind the dialog of files", async () => {
  HTMLDialogElement.prototype.showModal ??= () => {};
  at.show(<SequenceSection />);
  await press("Find");
  const choose = dialogOf(pickFile);
  await press("Open…");
  await act(() => moveStep(1, 0));
  const { changed } = useSequence.getState();
  const asked = ask.mock.calls.length;
  // The question is there whatever became of the section.
  act(() => useUi.setState({ open: [] }));
  await choose("/there/sequence.json");
  expect(at.host.querySelector("dialog")?.textContent).toContain("You changed the order by hand.");
  expect([ask.mock.calls.length, useSequence.getState().changed]).toEqual([asked, changed]);
  await press("Replace and open");
  expect(ask).toHaveBeenLastCalledWith("sequence", expect.objectContaining({ file: "/there/sequence.json" }));
  expect(at.host.querySelector("dialog")).toBeNull();
});

it("checks a file with the machine that is chosen by then, and its material", async () => {
  const other = { id: "other", name: "Another", default_material: "petg" };
  useFrame.setState(({ choices }) => ({
    choices: choices && { ...choices, strut_builders: [...choices.strut_builders, other] },
  }));
  at.show(<SequenceSection />);
  const choose = dialogOf(pickFile);
  await press("Open…");
  act(() => chooseBuilder("other"));
  await choose("/there/sequence.json");
  expect(ask).toHaveBeenLastCalledWith("sequence", expect.objectContaining({ machine: "other", material: "petg" }));
});

it("says that a file was not opened, or written, since a search was begun behind the dialog, which goes on", async () => {
  at.show(<SequenceSection />);
  await press("Find");
  const [open, save] = [dialogOf(pickFile), dialogOf(pickSave)];
  await press("Open…");
  await press("Save sequence…");
  ask.mockReturnValue(new Promise(() => {}));
  await press("Find");
  const asked = ask.mock.calls.length;
  await open("/there/sequence.json");
  await save("/there/other.json");
  expect(ask).toHaveBeenCalledTimes(asked);
  expect(useSequence.getState().asking).toBe(true);
  expect(said()).toEqual([
    "sequence.json was not opened. A sequence is being looked for. Open it after that.",
    "The sequence was not saved. A sequence is being looked for.",
  ]);
});

it("writes no sequence that was changed, or forgotten, behind the dialog, and says so", async () => {
  at.show(<SequenceSection />);
  await press("Find");
  const asked = ask.mock.calls.length;
  let choose = dialogOf(pickSave);
  await press("Save sequence…");
  act(() => chooseBuilder("other"));
  await choose("/there/sequence.json");
  act(() => chooseBuilder("builder"));
  choose = dialogOf(pickSave);
  await press("Save sequence…");
  act(forgetSequence);
  await choose("/there/sequence.json");
  expect(ask).toHaveBeenCalledTimes(asked);
  expect(said()).toEqual([
    "The sequence was not saved. Something was changed since.",
    "The sequence was not saved. It is not there any more.",
  ]);
});

it("shows that it saves, and asks for nothing meanwhile that would end that", async () => {
  at.show(<SequenceSection />);
  await press("Find");
  pickSave.mockResolvedValue("/there/sequence.json");
  let answer = (_: unknown) => {};
  ask.mockReturnValueOnce(new Promise((resolve) => (answer = resolve)));
  await press("Save sequence…");
  expect(at.host.querySelector("[role=status]")?.textContent).toBe("Saving the sequence…");
  const asked = ask.mock.calls.length;
  for (const name of ["Save sequence…", "Find", "Open…", "Earlier"]) {
    expect([name, button(name)?.title]).toEqual([name, "The sequence is being saved."]);
    await press(name);
  }
  expect([ask.mock.calls.length, pickSave.mock.calls.length]).toEqual([asked, 1]);
  await act(async () => answer(sequenceDrawn()));
  expect(button("Find")?.title).toBe("");
  expect(said()).toEqual(["The sequence is in /there/sequence.json."]);
});
