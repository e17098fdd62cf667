// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

vi.mock("../../platform", () => ({ platform: {}, Refused: class Refused extends Error {} }));

import type { Played } from "../../scene/interface";
import { place } from "../../shared/testing";
import { useByHand } from "../../state/machine/by_hand";
import { usePlayback } from "../../state/program/program";
import { useView } from "../../state/window/view";
import { PointerHint } from "./PointerHint";

const at = place();

beforeEach(() => {
  usePlayback.setState({ played: null });
  useByHand.setState({ played: null });
  useView.setState({ tool: "select" });
  at.show(<PointerHint />);
});

const clauses = () => [...at.host.querySelectorAll(".pointer-hint > span")].map(({ textContent }) => textContent);
const MOVES = ["Orbit: right or middle button", "Pan: Shift and middle button", "Zoom: wheel"];

it("has each clause by itself, so that a narrow view parts it between two of them and cuts none off", () => {
  expect(clauses()).toEqual(["Select: click, or drag a box", ...MOVES]);
  act(() => useView.setState({ tool: "draw" }));
  expect(clauses()).toEqual(["Draw: click for each corner, Esc ends", ...MOVES]);
});

it("says nothing of the tool while a program is played, which it does nothing to", () => {
  act(() => usePlayback.setState({ played: {} as Played }));
  expect(clauses()).toEqual(MOVES);
});
