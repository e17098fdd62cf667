import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
const pickSave = vi.hoisted(() => vi.fn());
const Refused = vi.hoisted(
  () =>
    class Refused extends Error {
      constructor(readonly refusal: { code: string }) {
        super(refusal.code);
      }
    },
);
vi.mock("../../platform", () => ({ platform: { ask, pickSave }, Refused }));

import { useDesign } from "../design/design";
import { designState } from "../testing";
import { forgetFrameFiles, replaceFrameFile, saveFrame, useFrameFiles } from "./files";
import { computeFrame, forgetFrame } from "./frame";
import { enlarge, showFrame } from "./shape";
import { frameShown, smallFrame } from "./testing";

beforeEach(async () => {
  ask.mockReset();
  pickSave.mockReset();
  forgetFrame();
  forgetFrameFiles();
  useDesign.setState({ ...smallFrame(), state: designState(), version: 1 });
  ask.mockResolvedValueOnce(frameShown());
  await computeFrame();
  showFrame({ kind: "loaded" });
});

it("writes the model as it is enlarged in the view", async () => {
  pickSave.mockResolvedValue("/there/frame.glb");
  enlarge(30);
  ask.mockResolvedValue({
    files: ["/there/frame.glb"],
    notes: [{ code: "drawn-round", message: "drawn as round", count: 1, remedies: [] }],
  });
  await saveFrame("glb");
  expect(ask).toHaveBeenLastCalledWith("save-frame", {
    frame: expect.objectContaining({ gravity: [0, 0, -1], forces: [] }),
    files: { glb: { path: "/there/frame.glb", force: true }, displacement_scale: 30 },
  });
  expect(useFrameFiles.getState()).toMatchObject({ busy: false, written: ["/there/frame.glb"], problem: null });
  expect(useFrameFiles.getState().notes).toHaveLength(1);
});

it("asks before it replaces tables, which the dialog of the system has not asked about", async () => {
  pickSave.mockResolvedValue("/there/frame.csv");
  ask.mockRejectedValueOnce(new Refused({ code: "exists" }));
  await saveFrame("csv");
  expect(ask.mock.lastCall?.[1].files.csv).toEqual({ path: "/there/frame.csv", force: false });
  expect(useFrameFiles.getState().problem?.exists).toBe(true);
  ask.mockResolvedValueOnce({ files: ["/there/frame-nodes.csv", "/there/frame-members.csv"], notes: [] });
  await replaceFrameFile();
  expect(ask.mock.lastCall?.[1].files.csv.force).toBe(true);
  expect(useFrameFiles.getState()).toMatchObject({ problem: null, written: { length: 2 } });
});

it("writes nothing where no place is chosen", async () => {
  pickSave.mockResolvedValue(null);
  ask.mockClear();
  await saveFrame("vtk");
  expect(ask).not.toHaveBeenCalled();
});
