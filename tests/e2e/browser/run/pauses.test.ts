import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  await editor.take("house", "animate", "run");
});
afterAll(() => editor?.end());

const run = () => editor.section("run");
const animate = () => editor.section("animate");
const button = (name: string) => run().getByRole("button", { name, exact: true });
const dialog = () => editor.page.getByRole("dialog");
const machine = async () => (await editor.loopback.ask("machine-state", {})).state;

it("stands at a pause point that was set in the step table, and goes on when a person says so", async () => {
  await animate().getByRole("option").nth(1).click();
  const note = animate().getByLabel("Pause after step 2", { exact: true });
  await note.fill("Turn the part");
  await note.press("Enter");
  await animate().getByRole("option").nth(1).getByTitle("Pause: Turn the part").waitFor();
  // The view stays where it is.
  await animate().getByRole("option", { selected: true }).filter({ hasText: /^2/ }).waitFor();
  await editor.isCleanNow("pause-set");
  await run().getByLabel("Port", { exact: true }).selectOption("sim:max");
  await button("Connect").click();
  await run().locator(".run-phase.connected").waitFor();
  await button("Arm…").click();
  await dialog().getByText("It waits after step 2: Turn the part", { exact: true }).waitFor();
  await dialog().getByRole("button", { name: "Arm", exact: true }).click();
  await run().locator(".run-phase.armed").waitFor();
  await button("Start").click();
  await dialog().getByText("Turn the part: is that done, and may the machine resume?", { exact: true }).waitFor();
  const standing = await machine();
  expect([standing?.wire?.made, standing?.wire?.sent]).toEqual([2, 2]);
  await editor.isCleanNow("pause-asked");
  await dialog().getByRole("button", { name: "Resume", exact: true }).click();
  await until(async () => (await machine())?.busy).toBe(false);
  const finished = await machine();
  expect(finished?.wire?.made).toBe(finished?.wire?.of);
});

it("bends five pieces in a row with the pause point in each, and asks for new wire among them", async () => {
  for (const [label, value] of [
    ["Pieces", "5"],
    ["Wire loaded", "1300"],
  ] as const) {
    const field = run().getByLabel(label, { exact: true });
    await field.fill(value);
    await field.press("Tab");
  }
  await button("Arm…").click();
  await dialog().getByText("Piece 1 of 5", { exact: true }).waitFor();
  await dialog().getByText("It waits after step 2: Turn the part", { exact: true }).waitFor();
  await dialog().getByRole("button", { name: "Arm", exact: true }).click();
  await run().locator(".run-phase.armed").waitFor();
  await button("Start").click();
  const answer = async (name: string) => {
    const id = (await machine())?.question?.id;
    await dialog().getByRole("button", { name, exact: true }).click();
    await until(async () => (await machine())?.question?.id !== id).toBe(true);
  };
  const asked: string[] = [];
  for (let piece = 1; piece <= 5; piece += 1) {
    if (piece > 1) {
      await dialog().getByText(`Piece ${piece} of 5`, { exact: true }).waitFor();
      const words = await dialog().innerText();
      asked.push(words.includes("Load new wire, 1300 mm") ? "load" : "cut");
      await answer("Bend it");
    }
    await dialog()
      .getByText(/^Turn the part: is that done/)
      .waitFor();
    const standing = await machine();
    expect([standing?.wire?.made, standing?.wire?.sent]).toEqual([2, 2]);
    await answer("Resume");
  }
  // A pause feeds nothing: 286 mm a piece, 686 mm have to be there, and 1300, 1014 and 727 suffice where 441 do not.
  expect(asked).toEqual(["cut", "cut", "load", "cut"]);
  await run()
    .getByText(/^Piece 5 of 5 is finished, in/)
    .waitFor();
  await until(async () => (await machine())?.busy).toBe(false);
  const { runs } = await editor.loopback.ask("runs", {});
  const row = runs.filter(({ piece }) => piece);
  expect(row.map(({ piece, outcome }) => [piece?.number, outcome])).toEqual(
    [1, 2, 3, 4, 5].map((number) => [number, "finished"]),
  );
});
