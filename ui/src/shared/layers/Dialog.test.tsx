// @vitest-environment happy-dom
import { act, useState } from "react";
import { beforeEach, expect, it } from "vitest";
import { place } from "../testing";
import { Dialog } from "./Dialog";

const at = place();

beforeEach(() => {
  HTMLDialogElement.prototype.showModal ??= () => {};
});

let close: () => void;

/** A section with a button that opens a dialog. `stays`: whether it is still there when the dialog is closed. */
function Opener({ stays }: { readonly stays: boolean }) {
  const [open, setOpen] = useState(false);
  const [there, setThere] = useState(true);
  close = () => {
    setOpen(false);
    setThere(stays);
  };
  return (
    <section>
      <h2>
        <button type="button">Head</button>
      </h2>
      {there && (
        <button type="button" id="opener" onClick={() => setOpen(true)}>
          Open
        </button>
      )}
      {open && <Dialog title="Asked">Text</Dialog>}
    </section>
  );
}

const openAndClose = async (stays: boolean) => {
  at.show(<Opener stays={stays} />);
  const opener = at.host.querySelector<HTMLElement>("#opener");
  opener?.focus();
  await act(async () => opener?.click());
  expect(document.activeElement?.className).toBe("dialog-body");
  await act(async () => close());
  return document.activeElement?.textContent;
};

it("gives the focus back to what has opened it", async () => {
  expect(await openAndClose(true)).toBe("Open");
});

it("gives the focus to the section of what has opened it where that is gone", async () => {
  expect(await openAndClose(false)).toBe("Head");
});

it("closes with Esc only the dialog that is in front", () => {
  const closed: string[] = [];
  at.show(
    <Dialog title="Calibrate" onClose={() => closed.push("Calibrate")}>
      <Dialog title="Replace?" onClose={() => closed.push("Replace?")}>
        Text
      </Dialog>
    </Dialog>,
  );
  const [behind, front] = at.host.querySelectorAll("dialog");
  act(() => void front?.dispatchEvent(new Event("cancel", { cancelable: true })));
  expect(closed).toEqual(["Replace?"]);
  act(() => void behind?.dispatchEvent(new Event("cancel", { cancelable: true })));
  expect(closed).toEqual(["Replace?", "Calibrate"]);
});
