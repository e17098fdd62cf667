import { afterAll, beforeAll, expect, it } from "vitest";
import { picture } from "../../support/browser.ts";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  await editor.take("house", "run");
});
afterAll(() => editor?.end());

const run = () => editor.section("run");
const button = (name: string) => run().getByRole("button", { name, exact: true });
const dialog = () => editor.page.getByRole("dialog");
const state = () => editor.machine();

async function fill(label: string, value: string): Promise<void> {
  const field = run().getByLabel(label, { exact: true });
  await field.fill(value);
  await field.press("Tab");
}

it("bends five pieces in a row, and asks for new wire when what is left does not suffice", async () => {
  await run().getByLabel("Port", { exact: true }).selectOption("sim:max");
  await button("Connect").click();
  await run().locator(".run-phase.connected").waitFor();
  await fill("Pieces", "5");
  await fill("Wire loaded", "1300");
  await button("Arm…").click();
  await dialog().getByText("Piece 1 of 5", { exact: true }).waitFor();
  await dialog().getByRole("button", { name: "Arm", exact: true }).click();
  await run().locator(".run-phase.armed").waitFor();
  await button("Start").click();
  const asked: string[] = [];
  for (let piece = 2; piece <= 5; piece += 1) {
    await dialog().getByText(`Piece ${piece} of 5`, { exact: true }).waitFor();
    const words = await dialog().innerText();
    expect(words).toContain("Cut off what was bent before and take it out");
    asked.push(words.includes("Load new wire, 1300 mm") ? "load" : "cut");
    if (piece === 4) {
      await editor.isCleanNow("pieces-load");
      await editor.page.setViewportSize({ width: 2560, height: 1440 });
      await picture(editor.page, "pieces-load-large");
      await editor.page.setViewportSize({ width: 1280, height: 800 });
    }
    const id = (await state()).question?.id;
    await dialog().getByRole("button", { name: "Bend it", exact: true }).click();
    await until(async () => (await state()).question?.id !== id).toBe(true);
  }
  // 286 mm are fed for a piece, and 686 mm have to be there: 1300, 1014 and 727 suffice, 441 do not.
  expect(asked).toEqual(["cut", "cut", "load", "cut"]);
  await run()
    .getByText(/^Piece 5 of 5 is finished, in/)
    .waitFor();
  await until(async () => (await state()).busy).toBe(false);
  const { runs } = await editor.loopback.ask("runs", {});
  expect(runs.map(({ piece, outcome }) => [piece?.number, outcome])).toEqual(
    [1, 2, 3, 4, 5].map((number) => [number, "finished"]),
  );
  await editor.isClean("pieces-done");
});

it("says before Start which wire is armed where that is not the one that is open, and whose it was in the end", async () => {
  await fill("Pieces", "1");
  await fill("Wire loaded", "1300");
  await button("Arm…").click();
  await dialog().getByRole("button", { name: "Arm", exact: true }).click();
  await run().locator(".run-phase.armed").waitFor();
  const says = run().getByText("Start bends the wire of House, armed before these changes.", { exact: true });
  // What is set here counts when a wire is armed.
  expect(await run().getByLabel("Pieces", { exact: true }).getAttribute("aria-disabled")).toBe("true");
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("Control+a");
  await editor.page.keyboard.press("Delete");
  await says.waitFor();
  await run().getByRole("heading", { name: "The wire that is armed" }).waitFor();
  await editor.isClean("armed-other");
  await editor.page.keyboard.press("Control+z");
  await says.waitFor({ state: "detached" });
  await run().getByRole("heading", { name: "Wire of the design" }).waitFor();
  await editor.page.keyboard.press("Control+y");
  await says.waitFor();
  await button("Start").click();
  await run()
    .getByText(/^The wire of House is finished, in/)
    .waitFor();
  await editor.isCleanNow("ended-other");
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("Control+z");
});

it("ends the row where a person says so, and keeps what was bent", async () => {
  await fill("Pieces", "3");
  await button("Arm…").click();
  await dialog().getByRole("button", { name: "Arm", exact: true }).click();
  await run().locator(".run-phase.armed").waitFor();
  await button("Start").click();
  await dialog().getByText("Piece 2 of 3", { exact: true }).waitFor();
  await dialog().getByRole("button", { name: "End here", exact: true }).click();
  await dialog().waitFor({ state: "detached" });
  await until(async () => (await state()).busy).toBe(false);
  await run()
    .getByText(/^Piece 1 of 3 is finished, in/)
    .waitFor();
  expect((await state()).unfinished).toBeNull();
  await editor.isCleanNow("pieces-ended");
});
