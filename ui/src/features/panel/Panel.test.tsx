// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it } from "vitest";
import { place } from "../../shared/testing";
import { PANEL, useUi } from "../../state/window/ui";
import { Panel } from "./Panel";

const at = place();

/** px; the view keeps 480 of them. */
const resize = (width: number) =>
  act(() => {
    Object.defineProperty(window, "innerWidth", { value: width, configurable: true });
    window.dispatchEvent(new Event("resize"));
  });
const edge = () => at.host.querySelector("[role=separator]") as HTMLElement;
const press = (key: string) =>
  act(() => void edge().dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true })));
const point = (type: string, clientX: number) =>
  act(() => void edge().dispatchEvent(new PointerEvent(type, { pointerId: 1, clientX, bubbles: true })));
/** As wide as it is shown, and as wide as it is said to be. */
const widths = () => [at.host.querySelector<HTMLElement>(".panel")?.style.width, edge().getAttribute("aria-valuenow")];

beforeEach(() => {
  resize(1000);
  useUi.setState({ panelWidth: PANEL.most });
  at.show(<Panel>words</Panel>);
  edge().setPointerCapture = () => {};
});

it("says how wide it is shown, where it was made wider in a larger window, and is that wide again there", () => {
  expect(widths()).toEqual(["520px", "520"]);
  expect(edge().getAttribute("aria-valuemax")).toBe("520");
  resize(2000);
  expect(widths()).toEqual(["720px", "720"]);
  expect(edge().getAttribute("aria-valuemax")).toBe("720");
});

it("goes with the keys and the pointer from where it is, and not from where it would be", () => {
  press("ArrowRight");
  expect(widths()).toEqual(["504px", "504"]);
  press("Home");
  expect(widths()).toEqual(["520px", "520"]);
  useUi.setState({ panelWidth: PANEL.most });
  point("pointerdown", 480);
  point("pointermove", 490);
  expect(widths()).toEqual(["510px", "510"]);
  point("pointermove", 400);
  expect(widths()).toEqual(["520px", "520"]);
});

it("does not lose the width of a larger window to a click on its edge", () => {
  point("pointerdown", 480);
  point("pointermove", 480);
  point("pointerup", 480);
  expect(useUi.getState().panelWidth).toBe(PANEL.most);
});
