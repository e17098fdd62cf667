import { afterAll, beforeAll, expect, it } from "vitest";
import { picture } from "../../support/browser.ts";
import { confirmed } from "../../support/brute.ts";
import { Editor, until } from "../../support/editor.ts";
import { root } from "../../support/places.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  const input = { file: `${root}examples/four-frame.json` };
  await editor.loopback.ask("open", { design: { input } });
  await editor.reload("sequence");
});
afterAll(() => editor?.end());

const section = () => editor.section("sequence");
const timeline = () => editor.page.getByRole("region", { name: "Timeline" });
const slider = () => editor.page.getByLabel("Position in the sequence");
const options = () => section().getByRole("listbox", { name: "Steps of building" }).getByRole("option");

it("finds the order in which four struts are built, as the command line does", async () => {
  await confirmed(editor, true, () => section().getByRole("button", { name: "Find", exact: true }).click());
  await until(() => options().count()).toBe(4);
  // docs/sequences.md.
  await section().getByText("0.0036 mm").first().waitFor();
  await until(() => slider().inputValue()).toBe("4");
});

it("steps, slides and goes back to the design", async () => {
  await editor.button("Step back").click();
  await until(() => slider().inputValue()).toBe("3");
  await timeline()
    .getByText(/^step 3 \/ 4 · edge 3$/)
    .waitFor();
  await options().nth(2).click();
  await section().getByRole("option", { selected: true }).filter({ hasText: /^3/ }).waitFor();
  await slider().fill("2.5");
  await timeline()
    .getByText(/^step 3 \/ 4 · edge 3$/)
    .waitFor();
  await picture(editor.page, "sequence-step");
  await section()
    .getByText(/^Colours of the layers/)
    .click();
  await picture(editor.page, "sequence-layers");
  await editor.isClean("sequence");
});

it("checks an order of one's own at once, and takes it back", async () => {
  await options().nth(2).click();
  await section().getByRole("button", { name: "Earlier" }).click();
  await section()
    .getByText(/^Your order can(not)? be built$/)
    .waitFor();
  await options().nth(1).click();
  await confirmed(editor, false, () => section().getByRole("button", { name: "Earlier" }).click());
  await section().getByText("Your order cannot be built").waitFor();
  await picture(editor.page, "sequence-wrong");
  await section().getByRole("button", { name: "Take back" }).click();
  await section()
    .getByText(/^Your order/)
    .waitFor({ state: "detached" });
  // A step that is dragged is where it was dropped, and is checked there.
  const edgeOf = async (step: number) =>
    await options()
      .nth(step - 1)
      .locator("span")
      .nth(1)
      .textContent();
  const [first, last] = [await edgeOf(1), await edgeOf(4)];
  await options().nth(3).dragTo(options().nth(0));
  await section().getByText("Your order cannot be built").waitFor();
  await until(() => edgeOf(1)).toBe(last);
  expect(await edgeOf(2)).toBe(first);
  await section().getByRole("button", { name: "Take back" }).click();
  await until(() => edgeOf(1)).toBe(first);
  await editor.button("Back to the design").first().click();
  await slider().waitFor({ state: "detached" });
});

it("places the struts of a wire together, once the walks of the wires are chosen", async () => {
  const wires = section().getByRole("radio", { name: /^A wire/ });
  expect(await wires.isDisabled()).toBe(true);
  const walks = [
    { start: 0, edges: [0, 2] },
    { start: 1, edges: [1, 3] },
  ];
  await editor.loopback.ask("edit", { request: { edit: "walks", walks } });
  await editor.reload("sequence");
  await section().getByText("A wire (2)").click();
  await confirmed(editor, true, () => section().getByRole("button", { name: "Find", exact: true }).click());
  await until(() => options().count()).toBe(2);
  await section().getByRole("option").filter({ hasText: "0 +1" }).waitFor();
  await options().first().click();
  await timeline()
    .getByText(/^step 1 \/ 2 · edge \d and 1 more$/)
    .waitFor();
  await picture(editor.page, "sequence-wires");
});

it("cancels a search at once, and keeps what was found before", async () => {
  const input = { file: `${root}examples/bunny-frame.pwf` };
  await editor.loopback.ask("open", { design: { input, units: "mm" } });
  await editor.reload("sequence");
  await section().getByRole("button", { name: "Find", exact: true }).click();
  await section().getByRole("button", { name: "Cancel", exact: true }).click();
  await section().getByText("Cancelled.").waitFor();
  await section().getByRole("button", { name: "Find", exact: true }).waitFor();
  await picture(editor.page, "sequence-cancelled");
});

it("says what is missing where nothing stands on the ground", async () => {
  await editor.take("house", "sequence");
  await section().getByRole("button", { name: "Find", exact: true }).click();
  await section().locator(".line.error, .mark.error").first().waitFor();
  expect(await options().count()).toBe(0);
});
