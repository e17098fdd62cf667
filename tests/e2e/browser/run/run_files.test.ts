import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Move } from "../../../../ui/src/generated/requests.ts";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  await editor.take("house", "run");
  await editor.loopback.ask("save-job", { output: { path: into("house.wbjob"), force: true } });
});
afterAll(() => editor?.end());

const into = (name: string) => join(editor.loopback.home, "files", name);
const run = () => editor.section("run");
const toRun = () => run().getByRole("group", { name: "File to run" });
const button = (name: string) => run().getByRole("button", { name, exact: true });
const dialog = () => editor.page.getByRole("dialog");
const state = () => editor.machine();
const stands = async (phase: string) => {
  await run().locator(`.run-phase.${phase}`).waitFor();
  await until(async () => (await state()).busy).toBe(false);
};
/** What the timeline says of the program that is played. */
const steps = () => editor.page.locator(".timeline-step");

async function bend(): Promise<void> {
  await button("Arm…").click();
  await dialog().getByRole("button", { name: "Arm", exact: true }).click();
  await stands("armed");
  await button("Start").click();
  await run()
    .getByText(/^The wire is finished, in/)
    .waitFor();
  await stands("ready");
}

it("opens a job, shows it, and runs it as it was planned", async () => {
  await editor.reload("run");
  await button("Connect").waitFor();
  await run().getByText("The open design", { exact: true }).waitFor();
  await editor.drop("house.wbjob", readFileSync(into("house.wbjob")));
  await toRun().getByText("job for WireBend-kit").waitFor();
  await toRun().getByText("Runs as it was planned").waitFor();
  await steps().getByText("step 5 / 5").waitFor();
  await run().getByLabel("Port", { exact: true }).selectOption("sim:max");
  await button("Connect").click();
  await stands("connected");
  await bend();
  await editor.isClean("run-file-job");
});

it("runs the text of a program as it stands, and says so before anything moves", async () => {
  await editor.drop("two.txt", "F 40\nB 60.5\nF 35\n");
  await editor.page.getByRole("dialog", { name: "Open two.txt" }).getByText("Run it as it stands").waitFor();
  await editor.isCleanNow("run-file-choice");
  await dialog().getByRole("button", { name: "Open", exact: true }).click();
  await toRun().getByText("program for WireBend-kit").waitFor();
  await toRun().getByText("Runs as it stands").waitFor();
  await toRun().getByText("Within the machine's limits").waitFor();
  await steps().getByText("step 2 / 2").waitFor();
  await button("Arm…").click();
  await dialog().getByText("The program two.txt runs as it stands: nothing of it is compensated").waitFor();
  await dialog().getByRole("button", { name: "Do not arm", exact: true }).click();
  await dialog().waitFor({ state: "detached" });
  await until(async () => (await state()).busy).toBe(false);
  await bend();
  expect((await state()).wire?.of).toBe(2);
  await editor.isClean("run-file-program");
});

it("says that a file was replaced on the disk, and runs it as it is now once it was read again", async () => {
  const path = into("two.txt");
  writeFileSync(path, "F 40\nB 50\nF 35\nB 20\nF 30\n");
  await button("Arm…").click();
  await editor.messages.filter({ hasText: "two.txt has changed on the disk since it was opened" }).waitFor();
  await editor.isCleanNow("run-file-changed");
  await toRun().getByRole("button", { name: "Read again" }).click();
  await steps().getByText("step 3 / 3").waitFor();
  await bend();
  expect((await state()).wire?.of).toBe(3);
});

it("refuses a program that the machine cannot make until a person wants it", async () => {
  await editor.drop("short.txt", "F 10\nB 45\nF 40\n");
  await dialog().getByRole("button", { name: "Open", exact: true }).click();
  await toRun().getByText("short.txt").waitFor();
  expect(await toRun().locator(".line").count()).toBeGreaterThan(1);
  expect(await button("Arm…").getAttribute("title")).toMatch(/cannot make the program as it stands/);
  await run().getByText("Bend it anyway, although the machine cannot make it").click();
  await bend();
  await editor.isCleanNow("run-file-despite");
});

it("replays a recording, and makes a design of it", async () => {
  const moves: Move[] = [
    { move: "home" },
    { move: "feed", mm: 60 },
    { move: "bend", deg: 45 },
    { move: "feed", mm: 50 },
  ];
  await editor.loopback.ask("order", { request: { order: "jog", moves, record: true } });
  await until(async () => (await state()).recorded).toBe(4);
  await stands("ready");
  await editor.loopback.ask("save-recording", { output: { path: into("corner.wbmoves"), force: true } });
  await editor.drop("corner.wbmoves", readFileSync(into("corner.wbmoves")));
  await dialog().getByText("Replay it").waitFor();
  await dialog().getByRole("button", { name: "Open", exact: true }).click();
  await toRun().getByText("recorded on WireBend-kit").waitFor();
  await steps().getByText("step 2 / 2").waitFor();
  expect(await button("Arm…").getAttribute("title")).toMatch(/replayed, not armed/);
  await toRun().getByRole("button", { name: "Replay…" }).click();
  await dialog().getByRole("button", { name: "Move", exact: true }).click();
  await until(async () => (await state()).question).toBe(null);
  await stands("ready");
  await editor.isClean("run-file-moves");
  await toRun().getByRole("button", { name: "Make it a design…" }).click();
  await dialog().getByText("Make it a design", { exact: true }).click();
  await dialog().getByRole("button", { name: "Open", exact: true }).click();
  await run().getByText("The open design", { exact: true }).waitFor();
  await until(async () => (await editor.design()).edges.length).toBe(2);
});
