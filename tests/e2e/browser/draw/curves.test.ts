import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

/** A ring with a radius of 30 mm: at a tolerance of 0.1 mm it has edges of 5 mm. */
const RING =
  '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100"><circle cx="50" cy="50" r="30"/></svg>';

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open({});
});
afterAll(() => editor?.end());

const dialog = () => editor.page.getByRole("dialog", { name: "Open ring.svg" });
const result = () => dialog().getByRole("status", { name: "Result" });

async function ask(): Promise<void> {
  await editor.take(null);
  const file = join(editor.loopback.home, "files", "ring.svg");
  writeFileSync(file, RING);
  await editor.drop("ring.svg", RING);
  await result().waitFor();
}

it("cuts a small circle to what the machine can make, and says how far off that is", async () => {
  await ask();
  await dialog()
    .getByText(/can make between bends of up to 90°/)
    .waitFor();
  await until(() => result().innerText()).toMatch(/[67] edges/);
  await editor.isClean("curves");
  await dialog().getByRole("button", { name: "Open", exact: true }).click();
  await until(async () => (await editor.design()).edges.length).toBeLessThanOrEqual(7);
  const check = await editor.loopback.ask("check", {});
  const codes = check.diagnostics.map(({ code }: { code: string }) => code);
  expect(codes).not.toContain("edge_too_short");
  expect(codes).not.toContain("feed_too_short");
});

it("shows at once what comes of the curve without a least length", async () => {
  await ask();
  await dialog().getByRole("checkbox", { name: "Limit edge length" }).uncheck();
  await until(() => result().innerText()).toMatch(/up to 0\.1/);
  await until(() => result().innerText()).toMatch(/(3\d|4\d) edges/);
  await dialog().getByRole("button", { name: "Cancel" }).click();
});

it("fixes all short edges by one change that one undo takes back", async () => {
  await editor.take(null);
  const comb: readonly (readonly [number, number])[] = [
    [0, 0],
    [0, 80],
    [12, 80],
    [12, 0],
    [27, 0],
    [27, 80],
    [41, 80],
    [41, 0],
  ];
  await editor.loopback.ask("edit", { request: { edit: "draw", through_mm: comb.map(([x, y]) => [x, y, 0]) } });
  await editor.reload("check");
  const line = editor.section("check").locator(".line").filter({ hasText: "too short" }).first();
  await line.getByRole("button", { name: /Fix…|List/ }).click();
  const offer = editor.section("check").getByRole("region", { name: "Fix all of this kind" });
  await offer.waitFor();
  await editor.isClean("fix-all");
  await offer.getByRole("button", { name: "Apply" }).click();
  const short = async () =>
    (await editor.loopback.ask("check", {})).diagnostics.filter(
      ({ code }: { code: string }) => code === "edge_too_short",
    ).length;
  await until(short).toBe(0);
  await editor.loopback.ask("undo", {});
  await until(short).toBe(3);
});
