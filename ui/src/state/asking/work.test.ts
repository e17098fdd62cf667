import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform }));

import { asking, hearWork, useWork } from "./work";

const work = (stage: string) => ({ ask: "look", stage, done: 0, of: 0, found: null });

beforeEach(() => useWork.setState({ works: new Map() }));

it("shows work for as long as a caller waits for it, and not what is reported of it afterwards", async () => {
  let answer = (_: object) => {};
  platform.ask.mockReturnValue(new Promise((resolve) => (answer = resolve)));
  const asked = asking("look", { design: { input: { file: "a.obj" } } });
  hearWork(work("reading"));
  expect(useWork.getState().works.get("look")?.stage).toBe("reading");
  answer({});
  await asked;
  hearWork(work("reading"));
  expect(useWork.getState().works.size).toBe(0);
});
