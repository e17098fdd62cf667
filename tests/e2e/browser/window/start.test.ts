import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open({ hints: true });
});
afterAll(() => editor?.end());

const dialog = (name: string | RegExp) => editor.page.getByRole("dialog", { name });
const name = () => editor.page.locator(".top-name").innerText();
const into = (file: string) => join(editor.loopback.home, "files", file);

it("leads through four steps once, and stands in the way of no menu", async () => {
  const note = editor.page.getByRole("note", { name: "First steps" });
  await note.getByText("Start with a shape").waitFor();
  await editor.isCleanNow("start-hint-first");
  const [hint, ...others] = await Promise.all(
    [note, editor.page.getByRole("heading", { name: "Drop a model or a drawing here" }), editor.button("Open…")].map(
      (of) => of.boundingBox(),
    ),
  );
  // It is read beside what it is about, not over it.
  for (const other of others) {
    const over =
      (hint?.x ?? 0) + (hint?.width ?? 0) > (other?.x ?? 0) &&
      (hint?.y ?? 0) < (other?.y ?? 0) + (other?.height ?? 0) &&
      (hint?.y ?? 0) + (hint?.height ?? 0) > (other?.y ?? 0);
    expect(over).toBe(false);
  }
  const clear = async () => {
    const boxes = await Promise.all(
      [
        note,
        editor.page.locator(".view-corner"),
        editor.page.locator(".panel"),
        editor.page.locator(".status-bar"),
      ].map((of) => of.boundingBox()),
    );
    const [own, ...around] = boxes.map((box) => box ?? { x: 0, y: 0, width: 0, height: 0 });
    const over = around.map(
      (box) =>
        own !== undefined &&
        own.x < box.x + box.width &&
        box.x < own.x + own.width &&
        own.y < box.y + box.height &&
        box.y < own.y + own.height,
    );
    expect(over, await note.innerText()).toEqual([false, false, false]);
    const [start, corner] = await Promise.all(
      [".start", ".view-corner"].map((of) => editor.page.locator(of).boundingBox()),
    );
    expect((start?.x ?? 0) + (start?.width ?? 0), "what to begin with").toBeLessThanOrEqual(corner?.x ?? 0);
  };
  await editor.page.setViewportSize({ width: 960, height: 600 });
  await clear();
  await editor.isCleanNow("start-hint-small");
  await note.getByRole("button", { name: "Next" }).click();
  await note.getByText("Choose the machine and the wire").waitFor();
  await clear();
  await editor.isCleanNow("start-hint-second-small");
  await editor.page.setViewportSize({ width: 1280, height: 800 });
  await clear();
  await editor.isCleanNow("start-hint");
  // It lies where the menus open: they come before it.
  await editor.menu("Help", "About WireBend-kit");
  await dialog("About WireBend-kit").getByText("Driver interface").waitFor();
  await editor.isCleanNow("start-about");
  await editor.page.keyboard.press("Escape");
  await note.getByRole("button", { name: "Next" }).click();
  await note.getByRole("button", { name: "Next" }).click();
  await note.getByRole("button", { name: "Done" }).click();
  await note.waitFor({ state: "detached" });
});

it("offers three examples as pictures, a plane to draw on, and all of the examples", async () => {
  await editor.page.getByRole("heading", { name: "Drop a model or a drawing here" }).waitFor();
  await until(() => editor.page.locator(".start-cards svg").count()).toBe(3);
  await editor.button("Draw on a plane").first().waitFor();
  await editor.isClean("start");
  await editor.button("All examples").click();
  const { examples } = await editor.loopback.ask("examples", {});
  await until(() => dialog("Examples").locator(".card").count()).toBe(examples.length);
  await editor.isClean("start-examples");
  await dialog("Examples")
    .getByRole("button", { name: /^Spring/ })
    .click();
  await until(name).toBe("Spring");
  expect(await editor.page.getByRole("heading", { name: "Drop a model" }).count()).toBe(0);
});

it("opens a file, and finds it again among those that were open before", async () => {
  const file = into("hook.obj");
  writeFileSync(file, "v 0 0 0\nv 60 0 0\nv 60 0 60\nl 1 2 3\n");
  await editor.choose(file, () => editor.menu("File", "Open…"));
  await dialog("Open hook.obj").getByText("60.0 × 0.0 × 60.0 mm").waitFor();
  await dialog("Open hook.obj").getByRole("button", { name: "Open", exact: true }).click();
  await until(name).toBe("hook.obj");
  await editor.menu("File", "New");
  await until(name).toBe("untitled");
  await editor.menu("File", "Open recent", "hook.obj");
  await dialog("Open hook.obj").getByText("60.0 × 0.0 × 60.0 mm").waitFor();
  await dialog("Open hook.obj").getByRole("button", { name: "Open", exact: true }).click();
  await until(name).toBe("hook.obj");
});

it("asks before it drops what no file has", async () => {
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("a");
  await editor.page.keyboard.press("s");
  await until(async () => (await editor.design()).vertices.length).toBe(5);
  await editor.menu("File", "New");
  const asks = dialog("Save hook.obj?");
  await editor.isCleanNow("start-leave");
  await asks.getByRole("button", { name: "Cancel" }).click();
  expect((await editor.design()).vertices).toHaveLength(5);
  await editor.menu("File", "New");
  await asks.getByRole("button", { name: "Save", exact: true }).click();
  await until(name).toBe("untitled");
  // Under the name that was suggested.
  expect(
    (await editor.loopback.ask("open", { design: { input: { file: into("hook.wirebend") } } })).design.vertices,
  ).toHaveLength(5);
  await editor.reload();
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("a");
  await editor.page.keyboard.press("x");
  await until(async () => (await editor.design()).vertices.length).toBe(0);
  await editor.menu("File", "New");
  await dialog("Save hook.wirebend?").getByRole("button", { name: "Do not save" }).click();
  await until(name).toBe("untitled");
});

it("brings back what was not saved when the program was killed", async () => {
  await editor.take("house", "edit");
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("a");
  for (const key of ["g", "z", "2", "5", "Enter"]) await editor.page.keyboard.press(key);
  await until(async () => (await editor.vertex(0))[2]).toBe(25);
  const { vertices, edges } = await editor.design();
  await editor.crash();
  const offer = editor.page.getByRole("region", { name: "Unsaved designs" });
  await offer.getByText("A design was not saved").waitFor();
  await offer.getByText(/house/i).waitFor();
  expect((await editor.design()).vertices).toEqual([]);
  await editor.isCleanNow("start-unsaved");
  await offer.getByRole("button", { name: "Restore" }).click();
  await until(async () => (await editor.design()).vertices.length).toBe(6);
  const after = await editor.design();
  expect({ vertices: after.vertices, edges: after.edges }).toEqual({ vertices, edges });
  expect(after.state.undo).not.toBeNull();
  await offer.waitFor({ state: "detached" });
});

it("says quietly how far work is, and nothing once it is over", async () => {
  const work = editor.page.locator(".status-work");
  let seen = false;
  // The answer comes once it was seen what is worked on.
  await editor.page.route("**/ask", async (route) => {
    const answer = await route.fetch();
    const first = !seen && route.request().postDataJSON().ask === "look";
    if (first) await work.waitFor();
    seen ||= first;
    await route.fulfill({ response: answer });
  });
  await editor.choose(into("hook.obj"), () => editor.menu("File", "Open…"));
  await dialog(/^Save/).getByRole("button", { name: "Do not save" }).or(dialog("Open hook.obj")).first().waitFor();
  await dialog("Open hook.obj").waitFor();
  await work.waitFor({ state: "detached" });
  expect(seen).toBe(true);
  await dialog("Open hook.obj").getByRole("button", { name: "Cancel" }).click();
  await editor.page.unrouteAll({ behavior: "wait" });
});
