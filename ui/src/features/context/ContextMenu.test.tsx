// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import { closeMenu, openMenu } from "../../state/window/context_menu";
import { ContextMenu } from "./ContextMenu";

const at = place();
afterEach(() => act(() => closeMenu()));

it.each([
  [null, "second"],
  ["second", "second"],
  // A question comes over a dialog that is written below it.
  ["first", "first"],
])("lies in the uppermost dialog, one below it being out of reach: the focus in %s", (focus, uppermost) => {
  at.show(
    <>
      {["first", "second"].map((id) => (
        <dialog key={id} open id={id}>
          <button type="button">Close</button>
        </dialog>
      ))}
      <ContextMenu />
    </>,
  );
  if (focus) act(() => at.host.querySelector<HTMLElement>(`#${focus} button`)?.focus());
  act(() => openMenu("window", { x: 0, y: 0 }));
  expect(at.host.querySelector("[role=menu]")?.closest("dialog")?.id).toBe(uppermost);
});
