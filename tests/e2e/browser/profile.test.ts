import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../support/editor.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  await editor.take("house", "machine");
});
afterAll(() => editor?.end());

const section = () => editor.section("machine");
const fold = (name: RegExp) => section().locator(".fold-head").filter({ hasText: name });
const dialog = () => editor.page.getByRole("dialog", { name: /^(Machine|Wire): / });
const row = (key: string) => dialog().locator(`.value-row[data-key="${key}"]`);
const field = (key: string) => row(key).locator("input").first();
const view = (id: string) => editor.loopback.ask("profile-view", { kind: "machine", id });
const reportOf = async (key: string) => (await view("my-bender")).profile.values.find((value) => value.key === key);
const enter = async (key: string, text: string) => {
  await field(key).fill(text);
  await field(key).press("Enter");
};

it("makes a machine of one's own from one that comes with the program", async () => {
  await fold(/^This machine/).click();
  await section().getByRole("button", { name: "Values…" }).click();
  await until(() => field("bend.orbit_radius_mm").getAttribute("aria-disabled")).toBe("true");
  await editor.isCleanNow("profile-shipped");
  await dialog().getByRole("button", { name: "Copy to my profiles…" }).click();
  await dialog().getByLabel("Name").fill("My bender");
  await dialog().getByRole("button", { name: "Copy", exact: true }).click();
  await editor.page.getByRole("dialog", { name: "Machine: My bender" }).waitFor();
  await until(() => field("bend.orbit_radius_mm").getAttribute("aria-disabled")).toBeNull();
  expect((await editor.design()).state.machine).toBe("my-bender");
});

it("takes a dimension with its source, draws it, and checks the open design at once", async () => {
  const program = await editor.loopback.ask("program", {});
  await enter("bend.orbit_radius_mm", "21,25");
  await row("bend.orbit_radius_mm").getByText("was 20.4 mm").waitFor();
  await row("bend.orbit_radius_mm").getByText("changed").waitFor();
  expect(await reportOf("bend.orbit_radius_mm")).toMatchObject({ value: 21.25, measured: true, set_by: "my-bender" });
  expect((await reportOf("bend.orbit_radius_mm"))?.source).toMatch(/^measured by me on \d{4}-\d\d-\d\d$/);
  const drawn = dialog().locator('.head-dimension[data-key="bend.orbit_radius_mm"]');
  await drawn.getByText("R 21.25 mm").waitFor();
  expect(await drawn.getAttribute("class")).toContain("active");
  const told = ({ wires }: typeof program) => wires[0]?.steps.map(({ told }) => told?.bend_deg);
  expect(told(await editor.loopback.ask("program", {}))).not.toEqual(told(program));
  // No edge of the house is as long as that.
  await enter("limits.min_edge_mm", "200");
  await dialog()
    .getByText(/Open design: \d+ to fix/)
    .waitFor();
  await editor.isClean("profile-machine");
});

it("moves nothing when a value is changed, refused or taken back", async () => {
  const at = async () => JSON.stringify(await row("limits.max_feed_mm").boundingBox());
  // What is typed into is brought into sight first.
  await field("limits.tail_mm").focus();
  const before = await at();
  await enter("limits.tail_mm", "-5");
  await row("limits.tail_mm").getByRole("alert").waitFor();
  expect(await at()).toBe(before);
  expect(await reportOf("limits.tail_mm")).toMatchObject({ value: 400 });
  await dialog().getByRole("button", { name: "Take back Shortest edge" }).click();
  await row("limits.min_edge_mm").getByText("changed").waitFor({ state: "detached" });
  expect(await at()).toBe(before);
  await dialog()
    .getByText(/Open design: (within limits|\d+ to look at)/)
    .waitFor();
  await dialog().getByRole("button", { name: "Undo the last change" }).click();
  await row("limits.min_edge_mm").getByText("changed").waitFor();
  await dialog().getByRole("button", { name: "Undo the last change" }).click();
  await row("limits.min_edge_mm").getByText("changed").waitFor({ state: "detached" });
});

it("changes the source alone, and lists only what is changed", async () => {
  await row("bend.orbit_radius_mm")
    .getByRole("button", { name: /^Change the source/ })
    .click();
  await dialog().getByLabel("Source of Orbit R", { exact: true }).fill("caliper, 3 readings");
  await dialog().getByRole("button", { name: "Set source" }).click();
  await row("bend.orbit_radius_mm").getByText("Measured: caliper, 3 readings").waitFor();
  expect(await reportOf("bend.orbit_radius_mm")).toMatchObject({ value: 21.25, source: "caliper, 3 readings" });
  await dialog().getByText("Changed (1)", { exact: true }).click();
  expect(await dialog().locator(".value-row").count()).toBe(1);
  await dialog().getByText("All", { exact: true }).click();
});

it("edits the bodies that a wire can hit", async () => {
  await dialog()
    .locator(".fold-head")
    .filter({ hasText: /^Bodies/ })
    .click();
  await dialog().getByRole("button", { name: "Figures of base" }).click();
  const height = dialog().getByLabel("base, size Z, mm");
  await height.fill("14");
  await height.press("Enter");
  await until(async () => (await view("my-bender")).shapes.find(({ name }) => name === "base")).toMatchObject({
    solid: { box: { size_mm: [460, 200, 14] } },
    measured: true,
  });
  await editor.isClean("profile-bodies");
});

it("gives the profile away as one file, and takes it in under another id", async () => {
  await dialog().getByRole("button", { name: "Export…" }).click();
  const file = join(editor.loopback.home, "my-bender.json");
  await editor.loopback.ask("export-profile", {
    kind: "machine",
    id: "my-bender",
    output: { path: file, force: true },
  });
  expect(JSON.parse(readFileSync(file, "utf8"))).toMatchObject({ id: "my-bender", inherits: "wirebend-kit" });
  await dialog().getByRole("button", { name: "Done" }).click();
  const given = join(editor.loopback.home, "given.json");
  writeFileSync(given, readFileSync(file, "utf8").replace('"My bender"', '"Bender of a friend"'));
  await editor.choose(given, () => section().getByRole("button", { name: "Import a profile…" }).click());
  await section().getByLabel("Other id").fill("friend");
  await editor.isCleanNow("profile-import");
  await section().getByRole("button", { name: "Import", exact: true }).click();
  await section().locator(".machine-card").filter({ hasText: "Bender of a friend" }).waitFor();
});

it("edits a wire: its springback as one angle or as a table", async () => {
  await fold(/^Wire/).click();
  await section().getByRole("button", { name: "Values of this wire…" }).click();
  await dialog().getByRole("button", { name: "Copy to my profiles…" }).click();
  await dialog().getByLabel("Name").fill("My spool");
  await dialog().getByRole("button", { name: "Copy", exact: true }).click();
  await editor.page.getByRole("dialog", { name: "Wire: My spool" }).waitFor();
  await dialog().getByLabel("Springback, °").fill("9.5");
  await dialog().getByLabel("Springback, °").press("Enter");
  await row("springback").getByText("was 10.23°").waitFor();
  await dialog().getByText("Table", { exact: true }).click();
  const loss = dialog().getByLabel("Positive bends, loss 2, °");
  await loss.fill("11");
  await loss.press("Enter");
  await until(
    async () =>
      (await editor.loopback.ask("profile-view", { kind: "material", id: "my-spool" })).profile.values.find(
        ({ key }) => key === "springback.positive",
      )?.value,
  ).toEqual([
    { angle_deg: 30, loss_deg: 9.5 },
    { angle_deg: 120, loss_deg: 11 },
  ]);
  await editor.isClean("profile-wire");
  await dialog().getByRole("button", { name: "Done" }).click();
});
