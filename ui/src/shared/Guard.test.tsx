// @vitest-environment happy-dom
import { act } from "react";
import { createRoot } from "react-dom/client";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Guard } from "./Guard";

(globalThis as { IS_REACT_ACT_ENVIRONMENT?: boolean }).IS_REACT_ACT_ENVIRONMENT = true;

// React writes down what was caught.
beforeEach(() => void vi.spyOn(console, "error").mockImplementation(() => {}));
afterEach(() => void vi.restoreAllMocks());

let broken = true;
function Fragile() {
  if (broken) throw new Error("no such thing");
  return <p>Whole</p>;
}

it("keeps what stands beside a part that fails, says which part that is, and tries it again", async () => {
  const place = document.createElement("div");
  await act(async () =>
    createRoot(place).render(
      <>
        <button type="button">STOP</button>
        <Guard name="Machine">
          <Fragile />
        </Guard>
      </>,
    ),
  );
  expect(place.querySelector("button")?.textContent).toBe("STOP");
  expect(place.querySelector("[role=alert]")?.textContent).toContain(
    "Machine cannot be shown because of an internal error: no such thing",
  );
  broken = false;
  await act(async () => place.querySelector<HTMLButtonElement>(".guard button")?.click());
  expect(place.textContent).toBe("STOPWhole");
});
