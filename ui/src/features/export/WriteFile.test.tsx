// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

vi.mock("../../platform", () => ({ platform: { ask: vi.fn() }, Refused: class Refused extends Error {} }));

import type { FormatEntry } from "../../generated/responses";
import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { setDespiteErrors, useExports } from "../../state/files/exports";
import { designState } from "../../state/testing";
import { WriteFile } from "./WriteFile";

const at = place();
const format = { id: "text", name: "Program", extension: "txt", program: true } as unknown as FormatEntry;

beforeEach(() => {
  useDesign.setState({ state: designState() });
});

it("can be written as soon as that is wanted all the same, also while the preview still has the errors", () => {
  const refused = { message: "The design has errors.", errors: true };
  useExports.setState({ preview: { format: "text", seen: null, refused }, despiteErrors: false });
  at.show(<WriteFile format={format} />);
  const write = () => at.host.querySelector("button.primary");
  expect(write()?.getAttribute("title")).toBe("The design has errors.");
  act(() => setDespiteErrors(true));
  expect(write()?.getAttribute("aria-disabled")).toBeNull();
});
