import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";

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
  const live = dialog().locator('.head-dimension[data-key="bend.orbit_radius_mm"]');
  await field("bend.orbit_radius_mm").fill("25");
  await live.getByText("R 25 mm").waitFor();
  // What is no number leaves the drawing as it was, and what is given up is not drawn any more.
  await field("bend.orbit_radius_mm").fill("25 x");
  await field("bend.orbit_radius_mm").fill("");
  await live.getByText("R 25 mm").waitFor();
  await field("bend.orbit_radius_mm").fill("26");
  await field("bend.orbit_radius_mm").press("Escape");
  await live.getByText("R 20.4 mm").waitFor();
  expect(await reportOf("bend.orbit_radius_mm")).toMatchObject({ value: 20.4, set_by: "wirebend-kit" });
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

it("says where a sign comes from, and takes a source for what the parent has", async () => {
  await row("signs.bend").getByText("The firmware of this program").waitFor();
  await row("signs.bend")
    .getByRole("button", { name: /^Change the source/ })
    .click();
  await row("signs.bend").getByRole("button", { name: "Measured by me today" }).click();
  await row("signs.bend").getByRole("button", { name: "Set source" }).click();
  await row("signs.bend").getByText("changed").waitFor();
  expect(await reportOf("signs.bend")).toMatchObject({ value: 1, measured: true, set_by: "my-bender" });
  expect((await reportOf("signs.bend"))?.source).toMatch(/^measured by me on/);
  await dialog().getByRole("button", { name: "Take back Bend", exact: true }).click();
  await row("signs.bend").getByText("changed").waitFor({ state: "detached" });
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

/** The bodies of the profile as they are saved. */
const saved = async () => (await view("my-bender")).shapes;
const body = async (name: string) => (await saved()).find((shape) => shape.name === name);
const bodyRow = (name: string) => dialog().locator(".body-row").filter({ hasText: name });
const picture = () => dialog().locator(".bodies-picture canvas");
/** The middle of the view, where the chosen body is once it is framed. */
const middle = async () => {
  const box = await picture().boundingBox();
  if (!box) throw new Error("there is no view");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
};
const inView = (name: string) => dialog().getByRole("group", { name: "View of the machine" }).getByText(name);
const look = async (side: string) => {
  await inView(side).click();
  await inView("Frame body").click();
};
const drag = async (from: { x: number; y: number }, by: readonly [number, number]) => {
  const { mouse } = editor.page;
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move(from.x + by[0] / 2, from.y + by[1] / 2);
  await mouse.move(from.x + by[0], from.y + by[1]);
  await mouse.up();
};

it("chooses a body in the list and in the view, and shows its figures", async () => {
  await dialog()
    .getByText(/^Bodies \(/)
    .click();
  await picture().waitFor();
  await bodyRow("base").click();
  await look("Front");
  await inView("Frame all").click();
  const height = dialog().getByLabel("base, size Z, mm");
  await height.fill("14");
  await height.press("Enter");
  await until(() => body("base")).toMatchObject({ solid: { box: { size_mm: [460, 200, 14] } }, measured: true });
  expect((await body("base"))?.source).toMatch(/^measured by me on/);
  await bodyRow("base").getByText("changed").waitFor();
  // A click beside everything chooses nothing, one on the base the base.
  await look("Front");
  const at = await middle();
  await editor.page.mouse.click(at.x, at.y + 120);
  await height.waitFor({ state: "detached" });
  await editor.page.mouse.click(at.x, at.y);
  await height.waitFor();
  await editor.isClean("profile-bodies");
});

it("adds a box at the pin, moves it in the view, and its fields follow", async () => {
  const before = (await saved()).length;
  await dialog().getByRole("button", { name: "Box", exact: true }).click();
  const x = dialog().getByLabel("box 1, middle X, mm");
  await x.waitFor();
  await until(async () => (await saved()).length).toBe(before + 1);
  const [startX = 0, startY, startZ] = (await body("box 1"))?.at_mm ?? [];
  await look("Front");
  const at = await middle();
  const { mouse } = editor.page;
  // By the arrow of x, to the right: only x changes, and the field shows it before the button is let go.
  await mouse.move(at.x + 40, at.y);
  await mouse.down();
  await mouse.move(at.x + 60, at.y + 15);
  await mouse.move(at.x + 110, at.y + 15);
  await until(async () => Number(await x.inputValue())).toBeGreaterThan(startX);
  expect((await body("box 1"))?.at_mm).toEqual([startX, startY, startZ]);
  const shown = Number(await x.inputValue());
  await mouse.up();
  await until(async () => (await body("box 1"))?.at_mm).toEqual([shown, startY, startZ]);
  expect(Number.isInteger(shown)).toBe(true);
  await dialog().getByRole("button", { name: "Undo the last change" }).click();
  await until(async () => (await body("box 1"))?.at_mm).toEqual([startX, startY, startZ]);
  await until(() => x.inputValue()).toBe(String(startX));
  // A drag beside the gizmo turns the view.
  await drag({ x: at.x + 5, y: at.y + 100 }, [40, 20]);
  expect((await body("box 1"))?.at_mm).toEqual([startX, startY, startZ]);
});

it("moves a body by keys alone, and gives a move up without closing the editor", async () => {
  const z = (await body("box 1"))?.at_mm[2] ?? 0;
  await picture().focus();
  await editor.keys("g", "z", "-", "1", "2", ".", "5", "Enter");
  await until(async () => (await body("box 1"))?.at_mm[2]).toBeCloseTo(z - 12.5, 9);
  await picture().focus();
  await editor.keys("g", "y", "9", "Escape");
  expect((await body("box 1"))?.at_mm[1]).toBe(0);
  await dialog().getByLabel("box 1, middle Y, mm").waitFor();
  await dialog().getByRole("button", { name: "Change the source of box 1" }).click();
  await dialog().getByLabel("Source of box 1", { exact: true }).fill("drawing 7");
  await dialog().getByText("Measured", { exact: true }).last().click();
  await dialog().getByRole("button", { name: "Set source" }).click();
  await until(() => body("box 1")).toMatchObject({ source: "drawing 7" });
});

it("follows what is typed before it is taken, and takes bodies back", async () => {
  const shot = async () => (await picture().screenshot()).toString("base64");
  await inView("Frame all").click();
  const before = await shot();
  const size = dialog().getByLabel("box 1, size X, mm");
  await size.fill("160");
  await until(async () => (await shot()) === before).toBe(false);
  expect(await body("box 1")).toMatchObject({ solid: { box: { size_mm: [20, 20, 20] } } });
  await size.press("Escape");
  await dialog().getByRole("button", { name: "Remove box 1" }).click();
  await until(() => body("box 1")).toBeUndefined();
  await bodyRow("base").click();
  await dialog().getByRole("button", { name: "Take back base" }).click();
  await until(() => body("base")).toMatchObject({ solid: { box: { size_mm: [460, 200, 12] } }, measured: false });
  await dialog().getByText("Values", { exact: true }).first().click();
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
  await row("springback")
    .getByRole("button", { name: /^Change the source/ })
    .click();
  await dialog().getByLabel("Source of Springback", { exact: true }).fill("two coupons");
  await dialog().getByRole("button", { name: "Set source" }).click();
  await row("springback").getByText("Measured: two coupons").waitFor();
  await editor.isClean("profile-wire");
  await dialog().getByRole("button", { name: "Done" }).click();
});
