import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  await editor.take("house", "machine");
});
afterAll(() => editor?.end());

const dialog = () => editor.page.getByRole("dialog", { name: "Calibrate machine and wire" });
const next = () => dialog().getByRole("button", { name: "Next", exact: true });
const cell = (name: string) => dialog().getByLabel(name, { exact: true });
let sheet = "";
const table = () => editor.loopback.ask("calibrate-sheet", { sheet });

it("makes coupons as jobs and a sheet in a folder", async () => {
  const section = editor.section("machine");
  await section
    .locator(".fold-head")
    .filter({ hasText: /^This machine/ })
    .click();
  await section.getByRole("button", { name: "Calibrate…" }).click();
  expect(await next().getAttribute("aria-disabled")).toBe("true");
  await dialog().getByLabel("Angles").fill("30 60 x");
  await dialog().getByText("Write angles up to 180°, such as 20, 45, 90.").waitFor();
  await dialog().getByLabel("Angles").fill("30, 60, 90");
  await dialog().getByRole("button", { name: "Make coupons in a folder…" }).click();
  await dialog().getByText("Bend these").waitFor();
  await dialog()
    .getByText(/6 coupons, each 2 times: .* of wire/)
    .waitFor();
  sheet = await dialog()
    .getByText(/sheet\.csv$/)
    .innerText();
  expect((await table()).jobs).toHaveLength(3);
  await dialog().getByText("For WireBend-kit with Aluminium 6061-T6, 3 mm.").waitFor();
  await editor.isClean("calibrate-coupons");
  // What is chosen afterwards is not what these are for.
  await dialog().getByLabel("Repeats").fill("3");
  await dialog().getByLabel("Repeats").press("Enter");
  await dialog().getByText("The choices were changed since these coupons were made").waitFor();
  await dialog().getByRole("button", { name: "Make coupons in a folder…" }).click();
  await dialog().getByText("There are coupons in calibration already").waitFor();
  await editor.isClean("calibrate-coupons-there");
  await dialog().getByLabel("Repeats").fill("2");
  await dialog().getByLabel("Repeats").press("Enter");
  await dialog().getByRole("button", { name: "Replace", exact: true }).click();
  await dialog().getByText("There are coupons in calibration already").waitFor({ state: "detached" });
  await dialog().getByText("The choices were changed").waitFor({ state: "detached" });
});

it("takes readings into a table, names the one that is typed wrong, and moves nothing by that", async () => {
  await next().click();
  await dialog().getByText("Readings of WireBend-kit with Aluminium 6061-T6, 3 mm").waitFor();
  const { rows } = await table();
  // A wire that springs back two degrees more than the profile says, read to half a degree.
  for (const { coupon, row, what, wanted } of rows) {
    const read = what === "bend" ? wanted - 2 * Math.sign(wanted) : what === "side" ? wanted + 3.1 : wanted;
    if (coupon !== "angle-60")
      await editor.loopback.ask("calibrate-enter", { sheet, readings: [`${coupon}:${row}=${read},${read + 0.2}`] });
  }
  const before = JSON.stringify(await cell("angle-90, row 1, reading 1").boundingBox());
  await cell("angle-60, row 1, reading 1").fill("58,1");
  await cell("angle-60, row 1, reading 1").press("Enter");
  // Enter goes down; what is missing may stay so.
  await until(() => editor.page.evaluate(() => document.activeElement?.getAttribute("aria-label"))).toBe(
    "angle-60, row 2, reading 1",
  );
  await editor.page.keyboard.type("-58");
  await editor.page.keyboard.press("Enter");
  await cell("angle-60, row 1, reading 2").fill("585");
  await cell("angle-60, row 1, reading 2").press("Enter");
  await dialog().getByText("585.0° cannot be; about 60.0° was to be expected").waitFor();
  await until(() => cell("angle-60, row 1, reading 2").getAttribute("aria-invalid")).toBe("true");
  await dialog()
    .getByText(/23 of 24 readings entered, 1 left out|\d+ of \d+ readings entered, 1 left out/)
    .waitFor();
  expect(JSON.stringify(await cell("angle-90, row 1, reading 1").boundingBox())).toBe(before);
  expect((await table()).rows.find(({ coupon }) => coupon === "angle-60")?.readings).toEqual([58.1, 585]);
  await editor.isClean("calibrate-measure");
});

it("says what the readings tell, how well, and what they do not tell", async () => {
  await next().click();
  const { kinds } = await editor.loopback.ask("calibrate-fit", { sheet });
  const bends = kinds.find(({ kind }) => kind === "bends");
  const region = dialog().getByRole("region", { name: "Bends", exact: true });
  await region.getByText(`scatter ${bends?.scatter.toFixed(2)}°`).waitFor();
  await region
    .getByText(`${bends?.before.mean_abs.toFixed(2)}°`)
    .first()
    .waitFor();
  expect(await region.locator(".residuals-point").count()).toBe(bends?.values.length);
  expect(await region.getByText("not determined", { exact: true }).count()).toBe(
    bends?.parameters.filter(({ identified }) => !identified).length,
  );
  await dialog().getByText("Left out: angle-60, reading 2").waitFor();
  await editor.isClean("calibrate-fit");
  await dialog().getByText("One angle", { exact: true }).click();
  await until(() =>
    dialog()
      .getByRole("row", { name: /^springback / })
      .count(),
  ).toBe(1);
  await dialog().getByText("Better", { exact: true }).click();
});

it("applies it to the design, shows what changes, and takes it back", async () => {
  await next().click();
  await dialog().getByRole("button", { name: "Apply", exact: true }).click();
  await dialog().getByText("The design was given my-wirebend-kit with my-aluminium-6061-t6-3mm").waitFor();
  await until(async () => (await editor.design()).state.machine).toBe("my-wirebend-kit");
  const row = dialog().getByRole("row", { name: /^Bends/ });
  await row.waitFor();
  const [was, is] = (await row.getByRole("cell").allInnerTexts()).map(Number.parseFloat);
  expect(was).toBeGreaterThan(1.5);
  expect(is).toBeLessThan(0.5);
  await editor.isClean("calibrate-apply");
  await editor.page.setViewportSize({ width: 2560, height: 1440 });
  await editor.isClean("calibrate-apply-large");
  await editor.page.setViewportSize({ width: 1280, height: 800 });
  await dialog().getByRole("button", { name: "Take back" }).click();
  await dialog().getByText("The design was given wirebend-kit again").waitFor();
  expect((await editor.design()).state.machine).toBe("wirebend-kit");
  // Applied once more it replaces what it has made, only when that is allowed.
  const apply = dialog().getByRole("button", { name: "Apply", exact: true });
  expect(await apply.getAttribute("aria-disabled")).toBe("true");
  await dialog().getByLabel("Replace the profiles that have these ids").check();
  await apply.click();
  await until(async () => (await editor.design()).state.machine).toBe("my-wirebend-kit");
  await dialog().getByRole("button", { name: "Done" }).click();
  await dialog().waitFor({ state: "detached" });
});

it("opens the sheet again where one left it, with what was applied, which other readings are not", async () => {
  await editor.section("machine").getByRole("button", { name: "Calibrate…" }).click();
  const first = cell("angle-60, row 1, reading 1");
  await first.waitFor();
  expect(await first.inputValue()).toBe("58.1");
  await first.fill("57,9");
  await first.press("Enter");
  await dialog().getByText("4  Apply").click();
  await dialog().getByText("The readings were changed since. Apply again to take them.").waitFor();
  await editor.isClean("calibrate-changed-since");
  await dialog().getByRole("button", { name: "Take back" }).click();
  await dialog().getByText("The design was given wirebend-kit again").waitFor();
  await dialog().getByText("The profiles that were replaced are as before.").waitFor();
});
