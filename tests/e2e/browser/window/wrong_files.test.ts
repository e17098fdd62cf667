import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";
import { wrongFiles } from "../../support/wrong.ts";

/** A profile that inherits from another, which does so from it. */
const profile = (id: string, inherits: string) =>
  JSON.stringify({ schema_version: 1, kind: "machine", id, name: id, inherits });

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open({}, (home) => {
    const machines = join(home, "own", "machines");
    mkdirSync(machines, { recursive: true });
    for (const [id, inherits] of [
      ["hen", "egg"],
      ["egg", "hen"],
    ] as const)
      writeFileSync(join(machines, `${id}.json`), profile(id, inherits));
  });
});
afterAll(() => editor?.end());

it("reports at once profiles that inherit from each other in a circle", async () => {
  await editor.messages.filter({ hasText: /hen\.json.*the parents run in a circle: hen -> egg -> hen/ }).waitFor();
  await editor.messages.filter({ hasText: "egg.json" }).waitFor();
  await editor.isCleanNow("wrong-profiles");
  // The rest of the machines are there.
  expect((await editor.loopback.ask("machines", {})).machines.length).toBeGreaterThan(3);
});

it("names every file that is wrong, and why, and continues with what was open", async () => {
  await editor.take("house", "edit");
  const into = (name: string) => join(editor.loopback.home, "files", name);
  await editor.loopback.ask("save", { path: into("house.wirebend") });
  await editor.loopback.ask("save-job", { output: { path: into("house.wbjob"), force: true } });
  await editor.reload("edit");
  const files = wrongFiles(readFileSync(into("house.wirebend"), "utf8"), readFileSync(into("house.wbjob"), "utf8"));
  expect(files.length).toBeGreaterThanOrEqual(20);
  const before = await editor.design();
  const said: Record<string, string> = {};
  for (const { name, contents } of files) {
    await editor.drop(name, contents);
    const message = editor.messages.filter({ hasText: name });
    const dialog = editor.page.getByRole("dialog", { name: `Open ${name}` });
    await message.or(dialog).first().waitFor();
    if (await dialog.isVisible()) {
      await dialog.getByRole("button", { name: "Open", exact: true }).click();
      await message.waitFor();
      await dialog.getByRole("button", { name: "Cancel" }).click();
      await dialog.waitFor({ state: "detached" });
    }
    said[name] = await message.innerText();
    // However long a message is, it stays in the window.
    expect(
      await message.evaluate((item) => item.scrollWidth <= item.clientWidth && item.getBoundingClientRect().top >= 0),
      name,
    ).toBe(true);
    await message.getByRole("button", { name: "Dismiss" }).click();
    await message.waitFor({ state: "detached" });
  }
  for (const { name, reason } of files) expect(said[name], name).toMatch(reason);
  expect(await editor.design()).toEqual(before);
  // It still is a window to work in.
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("a");
  await editor.section("edit").getByText("6 vertices · 6 edges").first().waitFor();
});

it("takes only the first of several files, and says so", async () => {
  await editor.page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    for (const name of ["a.obj", "b.obj"])
      dataTransfer.items.add(new File(["v 0 0 0\nv 50 0 0\nv 50 50 0\nl 1 2 3\n"], name));
    window.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  });
  await editor.messages.filter({ hasText: "Only the first of 2 files is opened" }).waitFor();
  const dialog = editor.page.getByRole("dialog", { name: "Open a.obj" });
  await dialog.getByRole("button", { name: "Open", exact: true }).click();
  await until(async () => (await editor.design()).state.name).toBe("a.obj");
  await editor.isClean("wrong");
});
