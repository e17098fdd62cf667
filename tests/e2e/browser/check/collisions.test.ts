import { afterAll, beforeAll, expect, it } from "vitest";
import type { ContactReport } from "../../../../ui/src/generated/responses.ts";
import { Editor, until } from "../../support/editor.ts";

let editor: Editor;
let contact: ContactReport;

beforeAll(async () => {
  editor = await Editor.open();
  await editor.take("house", "check", "animate");
  const { contacts } = await editor.loopback.ask("collisions", {});
  expect(contacts).toHaveLength(1);
  contact = contacts[0] as ContactReport;
});
afterAll(() => editor?.end());

const check = () => editor.section("check");
const animate = () => editor.section("animate");
const slider = () => animate().getByLabel("Position in the program");
const hit = () => editor.page.getByRole("status", { name: "What the wire meets" });
const position = () => contact.step + contact.at;

it("finds in Check what the wire hits on its way, frames it, and takes it back when the design no longer hits it", async () => {
  const line = check().locator(".line", {
    hasText: `The wire hits the ${contact.finding.body} in step ${contact.step + 1}`,
  });
  await line.waitFor();
  expect(await editor.phrase("check")).toBe("Warning: 1 to look at");
  expect(await line.locator(".line-sub").innerText()).toMatch(/mm deep; dimensions are estimates/);
  await line.locator(".line-button").click();
  await editor.isClean("check-collision");

  await line.locator(".line-action button").click();
  await line.getByRole("button", { name: "Enter dimensions…" }).click();
  const dialog = editor.page.getByRole("dialog");
  const chosen = () => dialog.locator(".body-row[aria-pressed=true] .ellipsis").allInnerTexts();
  const leave = async () => {
    await editor.page.keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
  };
  await until(chosen).toEqual([contact.finding.body]);
  await editor.isClean("check-enter-dimensions");
  await leave();

  // The same from the list of Animate.
  await animate().getByRole("button", { name: "Enter dimensions…" }).click();
  await until(chosen).toEqual([contact.finding.body]);
  await leave();

  // One bend reaches nothing.
  await editor.loopback.ask("new", {});
  await editor.loopback.ask("edit", {
    request: {
      edit: "draw",
      from: null,
      through_mm: [
        [0, 0, 0],
        [80, 0, 0],
        [80, 60, 0],
      ],
      to: null,
    },
  });
  await editor.reload("check");
  const none = check().locator(".line", { hasText: "No collision found with the machine or with the wire itself" });
  await none.getByRole("button", { name: "Enter dimensions…" }).click();
  await dialog.locator(".body-row").first().waitFor();
  await leave();
  expect(await editor.phrase("check")).toBe("Fine: within limits; no collision found");
});

it("stops playing where the wire hits something, says what, and plays on", async () => {
  await editor.take("house", "animate");
  const mark = editor.page.getByLabel("Timeline").getByRole("button", { name: /^Go to the collision/ });
  await mark.waitFor();
  expect(await mark.getAttribute("title")).toContain("its dimensions are estimates");
  await slider().fill(String(Math.floor(contact.step)));
  await animate().getByRole("button", { name: "Play" }).click();
  await hit()
    .getByText(new RegExp(`hits the ${contact.finding.body} when step ${contact.step + 1}`))
    .waitFor();
  await animate().getByRole("button", { name: "Play" }).waitFor();
  expect(Number(await slider().inputValue())).toBeCloseTo(position(), 1);
  await editor.isClean("animate-collision");

  await animate().getByRole("button", { name: "Play" }).click();
  await until(async () => Number(await slider().inputValue())).toBeGreaterThan(position() + 0.05);
  await animate().getByRole("button", { name: "Pause" }).click();
});

it("plays through where a person does not want it to stop, and goes to a collision from its mark and its line", async () => {
  const stops = animate().getByLabel("Stop at collisions");
  await stops.uncheck();
  await slider().fill(String(Math.max(position() - 0.1, 0)));
  await animate().getByRole("button", { name: "Play" }).click();
  await until(async () => Number(await slider().inputValue())).toBeGreaterThan(position() + 0.05);
  await animate().getByRole("button", { name: "Pause" }).click();
  await stops.check();
  for (const go of [
    animate().getByLabel("Collisions", { exact: true }).getByRole("button"),
    editor.page.getByLabel("Timeline").getByRole("button", { name: /^Go to the collision/ }),
  ]) {
    await slider().fill("0");
    await until(() => hit().innerText()).toBe("");
    await go.click();
    await hit()
      .getByText(/ goes /)
      .waitFor();
  }
});

it("says whose collisions it marks where the wire is shown as the machine bends it", async () => {
  const whose = animate().getByText("Collisions are those of the wire as designed.");
  expect(await whose.count()).toBe(0);
  await animate().getByText("As made", { exact: true }).click();
  await whose.waitFor();
  await editor.isClean("animate-collisions-as-made");
  await animate().getByText("As designed", { exact: true }).click();
  await until(() => whose.count()).toBe(0);
});

it("takes an order of the bends that hits nothing, keeps it with the design, and gives it up again", async () => {
  await editor.take("house", "edit", "animate");
  await animate().getByRole("button", { name: "Avoid collisions" }).click();
  await animate().getByText("No collision found.").waitFor();
  expect((await editor.design()).state.walks).toHaveLength(1);
  const edit = editor.section("edit");
  await edit.getByText("The order of the bends is chosen").waitFor();
  await editor.isClean("collisions-avoided");
  await edit.getByRole("button", { name: "Choose automatically" }).click();
  await animate().getByRole("button", { name: "Avoid collisions" }).waitFor();
});

it("names what comes nearer than the clearance of the design, and says how far the part sags", async () => {
  await editor.take("house", "check", "animate");
  const found = () => animate().getByRole("list", { name: "Collisions" }).getByRole("listitem").count();
  await until(found).toBe(1);
  await animate()
    .getByRole("button", { name: /^Collision settings/ })
    .click();
  const clearance = animate().getByLabel("Clearance", { exact: true });
  await clearance.fill("12");
  await clearance.press("Enter");
  await until(found).toBeGreaterThan(1);
  await animate().getByLabel("Let the part sag").click();
  await animate()
    .getByText(/^Its free end sags by up to \d+\.\d mm, in step \d/)
    .waitFor();
  await animate().getByText("Step 3 comes near the nozzle").first().waitFor();
  await check()
    .getByText(/^The wire comes near \d bodies of the machine/)
    .waitFor();
  await editor.isClean("animate-collision-settings");
  // The design keeps both, and undo takes them back.
  expect((await editor.design()).state.collisions).toEqual({ clearance_mm: 12, sag: true });
  for (const _ of [0, 1]) await editor.page.keyboard.press("Control+z");
  await until(found).toBe(1);
});
