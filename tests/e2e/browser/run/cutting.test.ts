/** Pieces that a bender on grbl cuts off: with a cutter, without one, and with one that the last bend would be pulled into. */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Responses } from "../../../../ui/src/generated/responses.ts";
import { Editor, until } from "../../support/editor.ts";
import { GrblBender } from "../../support/grbl.ts";
import { root } from "../../support/places.ts";

/** So long that the window shows it being done. */
const CUT = ["M8", "G4 P0.6", "M9"];
/** How far the blade is from where a wire begins, mm. */
const OUTSIDE_MM = 12.5;
const INSIDE_MM = -40;

let editor: Editor;
let bender: GrblBender;
beforeAll(async () => {
  bender = await GrblBender.start();
  editor = await Editor.open({}, (home) => {
    const machines = join(home, "own", "machines");
    mkdirSync(machines, { recursive: true });
    const machine = (id: string, name: string, settings: object) =>
      writeFileSync(
        join(machines, `${id}.json`),
        JSON.stringify({
          ...{ schema_version: 1, kind: "machine", id, name, inherits: "grbl-bender" },
          driver: { settings: { homing: "switches", pin_dwell_s: 0.05, ...settings } },
        }),
      );
    machine("shear", "Bender with a shear", { cut: CUT, cutter_mm: OUTSIDE_MM });
    machine("inside", "Bender with a shear inside", { cut: CUT, cutter_mm: INSIDE_MM });
    machine("uncut", "Bender without a shear", {});
  });
  // No system lists a terminal of a program among its ports.
  await editor.page.route("**/ask", async (route) => {
    if (!route.request().postData()?.includes('"ask":"ports"')) return route.fallback();
    const response = await route.fetch();
    const found = (await response.json()) as Responses["ports"];
    const port = { name: bender.port, description: "grbl", drivers: ["grbl"], likely_for: ["grbl"] };
    found.ports.push({ ...port, simulated: false, usb: null });
    await route.fulfill({ response, json: found });
  });
  const bytes = [...readFileSync(`${root}examples/u-sample.obj`)];
  await editor.take(null);
  await editor.loopback.ask("open", { design: { input: { bytes: { name: "u-sample.obj", bytes } }, units: "mm" } });
});
afterAll(async () => {
  await editor?.end();
  await bender?.end();
});

const run = () => editor.section("run");
const button = (name: string) => run().getByRole("button", { name, exact: true });
const dialog = () => editor.page.getByRole("dialog");
const state = () => editor.machine();
const box = () => run().getByLabel("Cut each piece off", { exact: true });
const stands = async (phase: string) => {
  await run().locator(`.run-phase.${phase}`).waitFor();
  await until(async () => (await state()).busy).toBe(false);
};
const answer = async (name: string) => {
  const id = (await state()).question?.id;
  await dialog().getByRole("button", { name, exact: true }).click();
  await until(async () => (await state()).question?.id !== id).toBe(true);
};
const pieces = async () =>
  (await editor.loopback.ask("runs", {})).runs.map(({ machine, piece, outcome }) => [
    machine,
    piece?.number,
    piece?.of,
    outcome,
  ]);

/** What is fed for a piece of the design, mm. */
async function fed(): Promise<number> {
  const { wires } = await editor.loopback.ask("program", {});
  return wires[0]?.steps.reduce((sum, { told }) => sum + (told?.feed_mm ?? Number.NaN), 0) ?? Number.NaN;
}

/** Chooses the machine for the design, and connects it. */
async function connect(machine: string): Promise<void> {
  await editor.loopback.ask("edit", { request: { edit: "machine", machine, material: "steel-1mm" } });
  await editor.reload("run");
  await run().getByLabel("Port", { exact: true }).selectOption(bender.port);
  await button("Connect").click();
  await stands("connected");
}

async function fill(label: string, value: string): Promise<void> {
  const field = run().getByLabel(label, { exact: true });
  await field.fill(value);
  await field.press("Tab");
}

async function disconnect(): Promise<void> {
  await button("Disconnect").click();
  await button("Connect").waitFor();
}

it("leaves the cut to a person where the machine has no cutter, and says why", async () => {
  await connect("uncut");
  expect((await state()).cutter_mm).toBeNull();
  expect(await box().isChecked()).toBe(false);
  expect(await box().isDisabled()).toBe(true);
  const why = "This machine has no cutter that the program knows of: cut each piece off by hand.";
  await run().getByTitle(why, { exact: true }).waitFor();
  await fill("Pieces", "2");
  await editor.isClean("cutting-none");
  await button("Arm…").click();
  await dialog().getByText("Piece 1 of 2", { exact: true }).waitFor();
  await answer("Arm");
  await stands("armed");
  await button("Start").click();
  await dialog().getByText("Piece 2 of 2", { exact: true }).waitFor();
  await dialog().getByText("Cut off what was bent before and take it out: this machine does not cut").waitFor();
  await editor.isCleanNow("cutting-by-hand");
  await answer("End here");
  await stands("ready");
  expect(await pieces()).toEqual([["uncut", 1, 2, "finished"]]);
  expect(bender.cuts).toEqual([]);
  await disconnect();
});

it("cuts off each piece without a question between them, until new wire has to be loaded", async () => {
  await connect("shear");
  expect((await state()).cutter_mm).toBe(OUTSIDE_MM);
  expect(await box().isChecked()).toBe(true);
  await fill("Pieces", "3");
  // A piece takes 105 mm at most, and 105 + 200 + 12.5 mm have to be there: 460 and 355 suffice, 250 do not.
  await fill("Wire loaded", "460");
  await editor.isCleanNow("cutting-set");
  await button("Arm…").click();
  for (const line of [
    "Piece 1 of 3",
    "After each piece the wire is fed farther by 12.5 mm, to the cutter, and cut",
    "Keep hands away from the cutter, and see that what falls off it lies clear of the machine",
    "The next piece begins without a question, as long as the wire that is loaded suffices",
  ])
    await dialog().getByText(line, { exact: true }).waitFor();
  await editor.isClean("cutting-asked");
  await answer("Arm");
  await stands("armed");
  await button("Start").click();
  await run().locator(".run-phase", { hasText: "cutting the wire off" }).waitFor();
  // What is set before a row stays as it is while it lasts.
  expect([await box().isChecked(), await box().isDisabled()]).toEqual([true, true]);
  await editor.isCleanNow("cutting-under-way");
  await dialog().getByText("Piece 3 of 3", { exact: true }).waitFor();
  expect(bender.cuts).toHaveLength(2);
  await dialog()
    .getByText(/^Load new wire, 460 mm of /)
    .waitFor();
  await dialog().getByText("Is new wire loaded, and may the machine move?", { exact: true }).waitFor();
  expect(await dialog().innerText()).not.toContain("Cut off what was bent before");
  await editor.isCleanNow("cutting-load");
  await answer("Bend it");
  await run()
    .getByText(/^Piece 3 of 3 is finished, in/)
    .waitFor();
  await stands("ready");
  const row = [1, 2, 3].map((number) => ["shear", number, 3, "finished"]);
  expect((await pieces()).slice(1)).toEqual(row);
  // Homing before each piece sets the feed to zero: each is cut where it ends, and bent as the one before.
  const length = await fed();
  expect(bender.cuts).toHaveLength(3);
  for (const at of bender.cuts) expect(Math.abs(at - length - OUTSIDE_MM)).toBeLessThan(0.05);
  const bends = bender.bends.slice(-6);
  expect([bends.slice(2, 4), bends.slice(4)]).toEqual([bends.slice(0, 2), bends.slice(0, 2)]);
  await editor.isCleanNow("cutting-done");
});

it("cuts nothing off, and asks before the next piece, where a person cuts", async () => {
  const before = bender.cuts.length;
  await box().uncheck();
  await fill("Pieces", "2");
  await fill("Wire loaded", "2000");
  await button("Arm…").click();
  await dialog().getByText("Piece 1 of 2", { exact: true }).waitFor();
  expect(await dialog().innerText()).not.toContain("cutter");
  await answer("Arm");
  await stands("armed");
  await button("Start").click();
  await dialog().getByText("Piece 2 of 2", { exact: true }).waitFor();
  await dialog().getByText("Cut off what was bent before and take it out", { exact: true }).waitFor();
  await answer("End here");
  await stands("ready");
  expect(bender.cuts).toHaveLength(before);
  await disconnect();
});

it("refuses a wire whose last bend the cutter would pull into the machine, until a person cuts", async () => {
  const known = (await pieces()).length;
  await connect("inside");
  await fill("Pieces", "2");
  await button("Arm…").click();
  // The last side is 35 mm, of which the bend takes a part.
  const refusal =
    /after its last bend, and the cutter is 40\.0 mm inside the machine: the bend would be pulled into it/;
  await editor.page.getByText(refusal).first().waitFor();
  await stands("connected");
  await editor.isClean("cutting-too-short");
  await box().uncheck();
  await button("Arm…").click();
  await dialog().getByText("Piece 1 of 2", { exact: true }).waitFor();
  await answer("Do not arm");
  expect(await pieces()).toHaveLength(known);
});
