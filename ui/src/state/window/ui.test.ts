import { describe, expect, it } from "vitest";
import { keptUi } from "./ui";

describe("what is kept of the window", () => {
  it("comes back", () => {
    expect(
      keptUi(JSON.stringify({ theme: "light", unit: "inch", open: ["edit", "run"], panelWidth: 500 }), 1280),
    ).toEqual({ theme: "light", unit: "inch", open: ["edit", "run"], panelWidth: 500 });
  });

  it.each([null, "", "nonsense", "null", "[]", '{"theme":7,"unit":"furlong","open":"all","panelWidth":"wide"}'])(
    "does no harm where it makes no sense: %s",
    (text) => {
      expect(keptUi(text, 1280)).toEqual({ theme: "system", unit: null, open: ["check"], panelWidth: 344 });
    },
  );

  it("keeps the panel within reach, and forgets sections that are not there", () => {
    expect(keptUi('{"panelWidth":9999,"open":["edit","gone"]}', 1280)).toMatchObject({
      panelWidth: 720,
      open: ["edit"],
    });
    expect(keptUi('{"panelWidth":3}', 1280).panelWidth).toBe(300);
  });

  it("takes more of a large window", () => {
    expect(keptUi(null, 2560).panelWidth).toBe(440);
  });
});
