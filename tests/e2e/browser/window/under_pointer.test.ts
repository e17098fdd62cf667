import { afterAll, beforeAll, expect, it } from "vitest";
import { Editor, until } from "../../support/editor.ts";
import { moved } from "../../support/movements.ts";

let editor: Editor;
beforeAll(async () => {
  editor = await Editor.open();
  await editor.take("house", "edit");
  await editor.section("edit").getByRole("row").nth(3).waitFor();
});
afterAll(() => editor?.end());

const heading = () => editor.section("edit").getByRole("heading", { name: "Operations", exact: true });

/** Puts so many px above the window, at once when something is clicked or `later` ms after it. */
const plant = (height: number, later: number | null = null) =>
  editor.page.evaluate(
    ([height, later]) => {
      const grow = () => {
        const planted = document.createElement("div");
        planted.className = "planted";
        planted.style.height = `${height}px`;
        document.querySelector("#root")?.prepend(planted);
      };
      addEventListener("click", () => (later === null ? grow() : setTimeout(grow, later)), { once: true });
    },
    [height, later] as const,
  );

/** Takes it away again, which moves everything as well. */
async function clear(): Promise<void> {
  await editor.page.evaluate(() => document.querySelector(".planted")?.remove());
  await moved();
}

it("finds what moves away from below the pointer, and the controls around it", async () => {
  await plant(24);
  await heading().click();
  expect(await moved()).toEqual(["h3 “Operations” by 0, 24; after a click on h3 “Operations”"]);
  await clear();

  await plant(24);
  await editor.page.getByRole("toolbar").getByRole("button", { name: /^Draw/ }).click();
  expect((await moved()).join()).toMatch(/^button “Draw on a plane.*” by 0, 24, 0, 24;/);
  await clear();
});

it("finds what moves later, while the pointer rests, and when a key is pressed", async () => {
  await plant(24, 400);
  await heading().click();
  await editor.page.locator(".planted").waitFor({ state: "attached" });
  expect((await moved()).join()).toContain("h3 “Operations” by 0, 24");
  await clear();

  await editor.page.evaluate(() =>
    addEventListener(
      "keydown",
      () => document.querySelector<HTMLElement>(".app")?.style.setProperty("margin-top", "9px"),
      {
        once: true,
      },
    ),
  );
  await editor.page.keyboard.press("Shift");
  expect((await moved()).join()).toContain("by 0, 9; after the key Shift");
  await editor.page.evaluate(() => document.querySelector<HTMLElement>(".app")?.style.removeProperty("margin-top"));
  await moved();
});

it("finds what has moved when the next action comes at once, and not what passes within a frame", async () => {
  /** Clicks twice, so many frames apart, as a hand that does not wait: both within the page, where nothing comes between. */
  const clickTwice = (frames: number, back: boolean) =>
    editor.page.evaluate(
      async ([frames, back]) => {
        const title = [...document.querySelectorAll("#section-edit h3")].find(
          (one) => one.textContent === "Operations",
        );
        const { left, top } = title?.getBoundingClientRect() ?? { left: 0, top: 0 };
        const [clientX, clientY] = [left + 4, top + 4];
        const press = () =>
          document
            .elementFromPoint(clientX, clientY)
            ?.dispatchEvent(new PointerEvent("pointerdown", { clientX, clientY, bubbles: true }));
        press();
        dispatchEvent(new PointerEvent("pointerup"));
        const app = document.querySelector<HTMLElement>(".app");
        app?.style.setProperty("margin-top", "24px");
        for (let frame = 0; frame < frames; frame += 1) await new Promise(requestAnimationFrame);
        if (back) app?.style.removeProperty("margin-top");
        press();
        dispatchEvent(new PointerEvent("pointerup"));
        app?.style.removeProperty("margin-top");
      },
      [frames, back] as const,
    );
  await clickTwice(4, false);
  expect((await moved()).join()).toContain("h3 “Operations” by 0, 24; after a click on h3 “Operations”");
  await clickTwice(1, true);
  expect(await moved()).toEqual([]);
});

it("finds what moves where a box scrolls because its contents have become too short", async () => {
  const box = await editor.page.evaluateHandle(() => {
    const made = document.createElement("div");
    made.style.cssText =
      "position: fixed; z-index: 99; left: 300px; top: 300px; width: 200px; height: 100px; overflow: auto";
    made.innerHTML = `<div style="height: 60px"></div><button>Planted</button><div class="end" style="height: 120px"></div>`;
    made.querySelector("button")?.addEventListener("click", () => made.querySelector(".end")?.remove());
    document.body.append(made);
    made.scrollTop = 60;
    return made;
  });
  await editor.page.getByRole("button", { name: "Planted" }).click();
  expect((await moved()).join()).toMatch(/^button “Planted” by 0, \d+, 0, \d+; after a click on button “Planted”$/);
  await box.evaluate((made) => made.remove());
  await moved();
});

it("takes for no movement what is scrolled, opened, or covered by a dialog that opens", async () => {
  await heading().hover();
  await editor.page.mouse.wheel(0, 60);
  await until(() => editor.page.locator(".panel-sections").evaluate(({ scrollTop }) => scrollTop)).toBeGreaterThan(0);
  expect(await moved()).toEqual([]);
  await editor.page.locator("#operation-split .operation-head").click();
  await editor.page.locator("#operation-split .operation-form").waitFor();
  expect(await moved()).toEqual([]);
  await editor.page.setViewportSize({ width: 1100, height: 700 });
  expect(await moved()).toEqual([]);
  await editor.page.setViewportSize({ width: 1280, height: 800 });
});
