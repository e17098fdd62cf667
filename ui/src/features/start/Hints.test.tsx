// @vitest-environment happy-dom
import { act } from "react";
import { expect, it, vi } from "vitest";

vi.mock("../../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {},
}));

import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { designState } from "../../state/testing";
import { useHints } from "../../state/window/hints";
import { Hints } from "./Hints";

const at = place();

it("asks for a shape until there is one, and continues with the machine then", () => {
  useHints.setState({ step: 0 });
  useDesign.setState({ state: designState(), vertices: new Map(), surfaces: new Map() });
  at.show(<Hints />);
  expect(at.host.textContent).toContain("Start with a shape");
  act(() =>
    useDesign.setState({ surfaces: new Map([[0, { positions: new Float32Array(9), triangles: new Uint32Array(3) }]]) }),
  );
  expect(at.host.textContent).toContain("Choose the machine and the wire");
});
