// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
vi.mock("../../../platform", () => ({ platform: { ask }, Refused: class Refused extends Error {} }));

import { place } from "../../../shared/testing";
import { useDesign } from "../../../state/design/design";
import { closeProfile, openBodies, openProfile } from "../../../state/machine/profile";
import { profileView } from "../../../state/machine/profile_testing";
import { designState } from "../../../state/testing";
import { ProfileEditor } from "./ProfileEditor";

const at = place();
let view = profileView();

beforeEach(() => {
  view = profileView();
  HTMLDialogElement.prototype.showModal ??= () => {};
  ask.mockReset();
  ask.mockImplementation(async (name: string) =>
    name.endsWith("profile") || name === "profile-view" ? view : { machines: [], materials: [] },
  );
  useDesign.setState({ state: designState({ machine: "mine" }) });
});

const row = (key: string) => at.host.querySelector<HTMLElement>(`[data-key="${key}"].value-row`);
const show = async () => {
  at.show(<ProfileEditor />);
  await act(() => openProfile("machine", "mine"));
};
const type = (input: Element | null | undefined, text: string) =>
  act(async () => {
    const field = input as HTMLInputElement;
    field.focus();
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, text);
    field.dispatchEvent(new Event("input", { bubbles: true }));
    field.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
  });

it("marks what is changed, with what it was, where it comes from, and the way back", async () => {
  await show();
  const pin = row("bend.pin_radius_mm");
  expect(pin?.querySelector("input")?.value).toBe("1.5875");
  expect(pin?.textContent).toContain("changed");
  expect(pin?.textContent).toContain("was 1.5 mm · Measured: caliper");
  expect(row("bend.orbit_radius_mm")?.textContent).not.toContain("changed");
  expect(at.host.textContent).toContain("Changed (1)");
  await act(async () => pin?.querySelector<HTMLElement>('[aria-label="Take back Pin radius"]')?.click());
  expect(ask).toHaveBeenCalledWith("revert-profile", { kind: "machine", id: "mine", keys: ["bend.pin_radius_mm"] });
});

it("opens the bodies where they are asked for, and the values the next time", async () => {
  const chosen = () =>
    at.host.querySelector('[aria-label="Part of the profile"] input:checked')?.closest("label")?.textContent;
  at.show(<ProfileEditor />);
  await act(async () => openBodies(null));
  expect(ask).toHaveBeenCalledWith("profile-view", { kind: "machine", id: "mine" });
  expect(chosen()).toMatch(/^Bodies/);
  await act(async () => closeProfile());
  await act(() => openProfile("machine", "mine"));
  expect(chosen()).toBe("Values");
});

it("shows a refusal at the value that was refused", async () => {
  await show();
  ask.mockImplementation((name: string) =>
    name === "set-profile" || name === "draw-head"
      ? Promise.reject(new Error("bend.orbit_radius_mm is -3, expected above 0"))
      : Promise.resolve({}),
  );
  await type(row("bend.orbit_radius_mm")?.querySelector("input"), "-3");
  expect(row("bend.orbit_radius_mm")?.querySelector('[role="alert"]')?.textContent).toContain("expected above 0");
});

it("marks the dimension of the field in use in the drawing", async () => {
  await show();
  act(() => row("bend.orbit_radius_mm")?.querySelector("input")?.focus());
  expect(at.host.querySelector(".head-dimension.active")?.getAttribute("data-key")).toBe("bend.orbit_radius_mm");
});

it("lets nobody type into a profile that comes with the program, and offers a copy", async () => {
  view = profileView({ shipped: true, has_last_change: false });
  await show();
  expect(row("bend.orbit_radius_mm")?.querySelector("input")?.readOnly).toBe(true);
  const copy = [...at.host.querySelectorAll("button")].find(
    ({ textContent }) => textContent === "Copy to my profiles…",
  );
  await act(async () => copy?.click());
  expect(at.host.querySelector("form")?.textContent).toContain("The design takes it as its machine");
});
