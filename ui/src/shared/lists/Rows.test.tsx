// @vitest-environment happy-dom
import { act } from "react";
import { expect, it, vi } from "vitest";
import { place } from "../testing";
import { Rows } from "./Rows";

const at = place();

it("takes what is typed in a row that is scrolled away, and leaves it while it is in sight", () => {
  const left = vi.fn();
  const render = (index: number) => (
    <div key={index}>
      <input aria-label={`row ${index}`} onBlur={left} />
    </div>
  );
  at.show(<Rows count={100} rowHeight={20} height={200} render={render} />);
  const field = at.host.querySelector<HTMLInputElement>('[aria-label="row 3"]');
  field?.focus();
  const box = at.host.querySelector(".rows");
  const scroll = (top: number) =>
    act(() => {
      if (box) box.scrollTop = top;
      box?.dispatchEvent(new Event("scroll", { bubbles: true }));
    });
  scroll(100);
  expect(left).not.toHaveBeenCalled();
  scroll(1000);
  expect(left).toHaveBeenCalledOnce();
});
