import { afterAll, beforeAll, expect, it } from "vitest";
import { picture } from "../../support/browser.ts";
import { Editor, until } from "../../support/editor.ts";
import { root } from "../../support/places.ts";
import { Sight } from "../../support/sight.ts";
import { holdsStill } from "../../support/still.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
});
afterAll(() => editor?.end());

const section = () => editor.section("frame");
const results = () => section().getByRole("table", { name: "Results" });
const legend = () => editor.page.getByRole("region", { name: "Legend" });

/** Opens a file of the examples, as File ▸ Open does. */
async function open(name: string, units: "mm" | null, ...sections: Parameters<Editor["reload"]>): Promise<void> {
  const input = { file: `${root}examples/${name}` };
  await editor.loopback.ask("open", { design: { input, units } });
  await editor.reload(...sections);
}

it("computes the bunny on its supports, and shows where it moves most", async () => {
  await open("bunny-frame.pwf", "mm", "frame");
  await section().getByLabel("Material").selectOption("abs-1-5mm");
  await holdsStill(
    editor.page,
    "computing",
    () => section().getByRole("button", { name: "Compute", exact: true }).click(),
    () => results().waitFor(),
    // What is below the results, for the first time.
    ".frame-below *, #section-frame ~ *",
  );
  // 0.427187 mm by OpenSees, PyNite and pyconmech: docs/frames.md.
  await results()
    .getByText(/^0\.427.mm$/)
    .waitFor();
  await results().getByRole("button", { name: "vertex 33" }).click();
  await legend()
    .getByText(/enlarged/)
    .waitFor();
  await picture(editor.page, "frame-loaded");
  await section().getByText("Axial force", { exact: true }).click();
  await legend()
    .getByText(/compression/)
    .waitFor();
  await picture(editor.page, "frame-axial");
});

it("draws at true scale, and enlarged by the slider", async () => {
  const slider = section().getByLabel("Scale of the displacements");
  await section().getByRole("button", { name: "True scale" }).click();
  await legend()
    .getByText(/drawn at true scale/)
    .waitFor();
  expect(await slider.inputValue()).toBe("0");
  await slider.focus();
  await editor.page.keyboard.press("End");
  await legend()
    .getByText(/drawn at .* × enlarged/)
    .waitFor();
});

it("swings a mode on demand alone", async () => {
  const modes = section().getByRole("list", { name: "Modes" }).getByRole("button");
  await modes.first().click();
  await legend()
    .getByText(/^Mode 1, /)
    .waitFor();
  await section().getByRole("button", { name: "Swing" }).click();
  await section().getByRole("button", { name: "Hold" }).click();
  await picture(editor.page, "frame-mode");
  await editor.isClean("frame");
  await editor.page.locator(".viewport canvas").focus();
  await editor.page.keyboard.press("Escape");
  await legend().waitFor({ state: "detached" });
});

it("holds the vertices that are clicked, and says what a frame that hangs on nothing needs", async () => {
  await editor.take("house", "frame");
  await section().getByRole("button", { name: "Compute", exact: true }).click();
  await section()
    .getByText(/support/i)
    .first()
    .waitFor();
  await until(() => editor.phrase("frame")).not.toContain("not computed yet");
  await section().getByText("Chosen (0)").click();
  await section().getByRole("button", { name: "Pick in the view" }).click();
  const { vertices } = await editor.design();
  const sight = await Sight.from(
    editor.page,
    "front",
    vertices.map(({ at_mm }) => at_mm),
  );
  for (const place of [vertices[0]?.at_mm, vertices[1]?.at_mm]) {
    if (!place) throw new Error("the house has no vertices");
    const { x, y } = sight.at(place);
    await editor.page.mouse.click(x, y);
  }
  await section().getByText("Chosen (2)").waitFor();
  await section().getByRole("button", { name: "Compute", exact: true }).click();
  await results()
    .getByText(/Largest displacement/)
    .waitFor();
});

it("closes the joints of a truss, and finds the tolerance that a requirement asks for", async () => {
  await editor.take("truss", "frame");
  await section().getByText("Free", { exact: true }).click();
  await section().getByLabel("Material").selectOption("steel-0-9mm");
  await section()
    .getByText(/close their joints/)
    .click();
  await section()
    .getByText(/^Run wires along edges twice/)
    .click();
  const drawn = section().getByLabel("Wires drawn");
  await drawn.fill("5");
  await drawn.press("Enter");
  await section().getByRole("button", { name: "Compute", exact: true }).click();
  await section().getByRole("table", { name: "Closed frame" }).waitFor();
  await section().getByText("As made", { exact: true }).first().click();
  await legend().getByText("As made").waitFor();
  await section().getByText("As closed", { exact: true }).first().click();
  await legend().getByText("As closed").waitFor();
  const force = section().getByLabel("Force", { exact: true });
  await force.fill("20");
  await force.press("Enter");
  await section().getByRole("button", { name: "Find the tolerance" }).click();
  const table = section().getByRole("table", { name: "Tolerance" });
  await table.getByText(/which governs/).waitFor();
  await picture(editor.page, "frame-closed");
});
