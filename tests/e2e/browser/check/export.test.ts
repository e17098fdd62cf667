import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  await editor.take("house", "export");
  await format().waitFor();
});
afterAll(() => editor?.end());

const section = () => editor.section("export");
const format = () => section().getByLabel("Format");
const target = () => section().getByLabel("File");
const write = () => section().getByRole("button", { name: "Write", exact: true });
const preview = () => section().locator(".preview pre");
const into = (name: string) => join(editor.loopback.home, "files", name);

/** How files begin that are no text, by the definitions of their formats. */
const BEGINNINGS: Readonly<Record<string, string>> = {
  gltf: "glTF",
  png: "\u0089PNG",
  "template-pdf": "%PDF-",
  "job-sheet": "%PDF-",
};

it("leads to the other machines, for a person who wants a file for one of them", async () => {
  await section().getByText("For WireBend-kit", { exact: true }).waitFor();
  await section().getByRole("button", { name: "Another machine…" }).click();
  const list = editor.page.getByRole("dialog", { name: "Machine" });
  await list.getByText("Pensa", { exact: false }).first().waitFor();
  await editor.isCleanNow("export-machines");
  await editor.page.keyboard.press("Escape");
  await list.waitFor({ state: "detached" });
});

it("writes each format of the machine, and each file begins as was shown", async () => {
  const { formats } = await editor.loopback.ask("exports", {});
  expect(formats.map(({ id }) => id)).toEqual(
    expect.arrayContaining([
      "wirebend-kit-text",
      "lra-csv",
      "template-pdf",
      "template-dxf",
      "job-sheet",
      "svg",
      "png",
      "obj",
    ]),
  );
  for (const { id, extension } of formats) {
    await format().selectOption(id);
    const shown = await editor.loopback.ask("export", { format: id, settings: {} });
    const beginning = shown.beginnings[0] ?? null;
    if (beginning === null)
      await section()
        .locator(".preview figcaption", { hasText: /binary file: no preview|pages to print/ })
        .waitFor();
    else await until(() => preview().first().textContent()).toBe(beginning);
    const file = into(`out-${id}.${extension}`);
    await target().fill(file);
    await write().click();
    await section()
      .locator(".written", { hasText: file.replace(`.${extension}`, "") })
      .first()
      .waitFor();
    const [written = file] =
      shown.bytes.length > 1 ? await section().locator(".written .selectable").allInnerTexts() : [file];
    const bytes = readFileSync(written);
    if (beginning !== null)
      expect(bytes.toString("utf8").replaceAll("\r\n", "\n").startsWith(beginning.replaceAll("\r\n", "\n")), id).toBe(
        true,
      );
    const begins = BEGINNINGS[id];
    if (begins) expect(bytes.toString("latin1").startsWith(begins), id).toBe(true);
    // A sheet carries the time at which it was written.
    if (id !== "job-sheet") expect(bytes.length, id).toBe(shown.bytes[0]);
  }
});

it("says that a file is written where a person sees it, in a low window too", async () => {
  const whole = editor.page.viewportSize();
  await editor.page.setViewportSize({ width: 1280, height: 600 });
  // The preview comes after the file: the last moment at which something can move the line.
  let letGo = (): void => {};
  const held = new Promise<void>((go) => (letGo = go));
  await editor.page.route("**/ask", async (route) => {
    const asked = route.request().postDataJSON() as { ask: string; output?: unknown };
    if (asked.ask === "export" && !asked.output) await held;
    await route.continue();
  });
  await format().selectOption("lra-csv");
  // Its two lines are higher than the button, which still may not move under the pointer: each test looks at that.
  const name = `${"a-name-of-two-lines-".repeat(3)}low.csv`;
  await target().fill(into(name));
  // The last that is seen of the panel is the button.
  await write().evaluate((button) => button.scrollIntoView({ block: "end" }));
  await write().click();
  const written = section().locator(".written", { hasText: name });
  await written.waitFor();
  const isSeen = (at: Element): boolean => {
    const { left, right, top, bottom } = at.getBoundingClientRect();
    return at.contains(document.elementFromPoint((left + right) / 2, (top + bottom) / 2));
  };
  await until(() => written.evaluate(isSeen)).toBe(true);
  letGo();
  await preview().first().waitFor();
  await until(() => written.evaluate(isSeen)).toBe(true);
  await editor.page.unroute("**/ask");
  if (whole) await editor.page.setViewportSize(whole);
});

it("shows at once what a setting changes", async () => {
  await format().selectOption("lra-csv");
  await until(() => preview().first().textContent()).toMatch(/,/);
  await section()
    .getByRole("button", { name: /^Settings of this export/ })
    .click();
  await section().getByLabel("Separator", { exact: true }).selectOption("semicolon · ;");
  await until(() => preview().first().textContent()).toMatch(/;/);
  // Choices between true, false and nothing are such fields too.
  const before = await preview().first().textContent();
  await section().getByLabel("Header", { exact: true }).selectOption("no");
  await until(() => preview().first().textContent()).not.toBe(before);
  await section().getByLabel("Header", { exact: true }).selectOption("not set");
  await until(() => preview().first().textContent()).toBe(before);
  await section().getByText("1 change from the profile").waitFor();
  await editor.isCleanNow("export-settings");
});

it("replaces a file that is there only when a person says so", async () => {
  await format().selectOption("wirebend-kit-text");
  await until(() => preview().first().textContent()).toMatch(/\w/);
  const file = into("mine.txt");
  writeFileSync(file, "keep me");
  await target().fill(file);
  await write().click();
  await section().getByText("The file exists already").waitFor();
  expect(readFileSync(file, "utf8")).toBe("keep me");
  await editor.isCleanNow("export-exists");
  await section().getByRole("button", { name: "Replace" }).click();
  await section().locator(".written", { hasText: "mine.txt" }).waitFor();
  expect(readFileSync(file, "utf8")).not.toBe("keep me");
});

it("says why a file cannot be written where it was named", async () => {
  await target().fill(into("no-such-folder/mine.txt"));
  await write().click();
  await section().getByText("The file was not written").waitFor();
  expect(await section().getByRole("alert").innerText()).toContain("no-such-folder");
});

it("writes a program of what the machine cannot make only when that is said", async () => {
  await editor.take("bunny", "export");
  await editor.loopback.ask("edit", { request: { edit: "doublings", edges: doubles } });
  await editor.reload("export");
  await section().getByText("The machine cannot bend this", { exact: true }).waitFor();
  const file = into("bunny.txt");
  await target().fill(file);
  await until(() => write().getAttribute("aria-disabled")).toBe("true");
  await section().getByLabel("Write it anyway").check();
  await until(() => write().getAttribute("aria-disabled")).toBeNull();
  await write().click();
  await section().locator(".written", { hasText: "bunny.txt" }).waitFor();
  expect(existsSync(file)).toBe(true);
  // A picture is no program: the user need not be asked.
  await section().getByLabel("Write it anyway").uncheck();
  await format().selectOption("svg");
  await until(() => preview().first().textContent()).toMatch(/<svg/);
  await editor.isClean("export");
});

it("says of an empty design that there is nothing to show yet, and not that it cannot be made", async () => {
  await editor.take(null, "export");
  await section().getByText("Draw an edge to see").waitFor();
  expect(await section().getByText("The machine cannot bend this").count()).toBe(0);
  expect(await write().count()).toBe(0);
});

it("writes the document, the wireframe and the job to continue with", async () => {
  await editor.take("house", "export");
  await section().getByRole("button", { name: "Job…" }).click();
  await editor.messages.filter({ hasText: "The job is in" }).waitFor();
  await section().getByRole("button", { name: "Wireframe…" }).click();
  await editor.messages.filter({ hasText: "The wireframe is in" }).waitFor();
  const { vertices, edges, state } = await editor.design();
  const lines = readFileSync(into("House.obj"), "utf8").split("\n");
  expect([
    lines.filter((line) => line.startsWith("v ")).length,
    lines.filter((line) => line.startsWith("l ")).length,
  ]).toEqual([vertices.length, edges.length]);
  await section().getByRole("button", { name: "Document…" }).click();
  await editor.page.getByRole("contentinfo").getByText("saved", { exact: true }).waitFor();
  const saved = JSON.parse(readFileSync(into("House.wirebend"), "utf8"));
  expect([saved.wireframe.vertices.length, saved.wireframe.edges.length]).toEqual([vertices.length, edges.length]);
  const job = JSON.parse(readFileSync(into("House.wbjob"), "utf8"));
  expect(job.machine.id).toBe(state.machine);
  expect(job.hash).toBe((await editor.loopback.ask("program", {})).job_hash);
});

/** The edges of the example that its own fix doubles. */
const doubles = [25, 28, 50, 55, 70, 88, 90, 116, 122, 131, 145];
