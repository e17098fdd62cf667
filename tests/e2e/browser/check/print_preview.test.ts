import { readFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  // As in the window that is installed: what a page may load, and objects that nobody adds to.
  const config = JSON.parse(readFileSync(new URL("../../../../src-tauri/tauri.conf.json", import.meta.url), "utf8"));
  await editor.page.route(
    (url) => url.pathname === "/",
    async (route) => {
      const response = await route.fetch();
      const headers = { ...response.headers(), "content-security-policy": config.app.security.csp };
      await route.fulfill({ response, headers });
    },
  );
  await editor.page.addInitScript(() => Object.freeze(Object.prototype));
  await editor.take("house", "export");
  await format().waitFor();
});
afterAll(() => editor?.end());

const section = () => editor.section("export");
const format = () => section().getByLabel("Format");
const open = () => section().getByRole("button", { name: "Print preview…" });
const dialog = () => editor.page.getByRole("dialog", { name: /^Print preview/ });
const canvas = () => dialog().locator(".print-page canvas");

/** How much of a page is dark, of a thousand parts. */
const ink = () =>
  canvas()
    .first()
    .evaluate((shown: HTMLCanvasElement) => {
      const all = shown.getContext("2d")?.getImageData(0, 0, shown.width, shown.height).data ?? new Uint8ClampedArray();
      let dark = 0;
      for (let at = 0; at < all.length; at += 4) if ((all[at] ?? 255) < 128 && (all[at + 3] ?? 0) > 128) dark += 1;
      return (dark / Math.max(1, all.length / 4)) * 1000;
    });

/** The pages of a file, by its own objects. */
const pagesOf = (bytes: Buffer) => bytes.toString("latin1").match(/\/Type \/Page\b/g)?.length ?? 0;

const written = async (id: string) => {
  const { contents } = await editor.loopback.ask("export", { format: id, settings: {}, contents: true });
  return Buffer.from(contents[0] ?? "", "base64");
};

it("shows the pages of the file that is saved", async () => {
  const loaded = () =>
    editor.page.evaluate(
      () => performance.getEntriesByType("resource").filter(({ name }) => /\/pdf/.test(name)).length,
    );
  expect(await loaded()).toBe(0);
  for (const id of ["job-sheet", "template-pdf"]) {
    await format().selectOption(id);
    await until(() => open().getAttribute("aria-disabled")).toBeNull();
    await open().click();
    const bytes = await written(id);
    const count = pagesOf(bytes);
    expect(count).toBeGreaterThan(1);
    await dialog().getByText(`Page 1 of ${count}`).waitFor();
    await until(ink).toBeGreaterThan(2);
    expect(await loaded()).toBeGreaterThan(0);
    // The whole page is in sight.
    const [page, pages] = await Promise.all([
      canvas().first().boundingBox(),
      dialog().getByLabel("Pages").boundingBox(),
    ]);
    expect((page?.height ?? 0) + (page?.y ?? 0)).toBeLessThanOrEqual((pages?.height ?? 0) + (pages?.y ?? 0));
    await editor.isClean(`print-${id}`);
    await dialog().getByRole("button", { name: "Save…" }).click();
    await dialog()
      .getByText(/^Written: /)
      .waitFor();
    const file = id === "job-sheet" ? "House-sheet.pdf" : "House-template.pdf";
    expect(readFileSync(join(editor.loopback.home, "files", file)).equals(bytes), id).toBe(true);
    await editor.page.keyboard.press("Escape");
    await dialog().waitFor({ state: "detached" });
    expect(await open().evaluate((button) => button === document.activeElement)).toBe(true);
  }
});

it("goes to the last page by the keyboard, and stays on a page that becomes larger", async () => {
  await format().selectOption("template-pdf");
  await until(() => open().getAttribute("aria-disabled")).toBeNull();
  await open().click();
  const count = pagesOf(await written("template-pdf"));
  await dialog().getByText(`Page 1 of ${count}`).waitFor();
  await editor.page.keyboard.press("End");
  await dialog().getByText(`Page ${count} of ${count}`).waitFor();
  const width = async () => (await canvas().last().boundingBox())?.width ?? 0;
  const before = await width();
  const bar = dialog().getByRole("radiogroup", { name: "Zoom" });
  const at = await bar.boundingBox();
  await bar.getByText("Page width").click();
  await until(width).toBeGreaterThan(before * 1.2);
  await dialog().getByText(`Page ${count} of ${count}`).waitFor();
  // What was clicked is still under the pointer.
  expect(await bar.boundingBox()).toEqual(at);
  await until(ink).toBeGreaterThan(2);
  await editor.page.keyboard.press("Escape");
});

it("has lengths in the unit that the window shows", async () => {
  await editor.button("mm, the unit of lengths: change it").click();
  await format().selectOption("job-sheet");
  const asked = editor.page.waitForRequest((request) => (request.postData() ?? "").includes('"contents":true'));
  await until(() => open().getAttribute("aria-disabled")).toBeNull();
  await open().click();
  expect((await asked).postDataJSON()).toMatchObject({ format: "job-sheet", settings: { units: "in" } });
  await until(ink).toBeGreaterThan(2);
  await editor.isCleanNow("print-inches");
  await editor.page.keyboard.press("Escape");
  await editor.button("in, the unit of lengths: change it").click();
});
