import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { button, Driven, says } from "../support/installed.ts";
import { seat } from "../support/seat.ts";

/** How long the page does nothing else, ms. */
const BUSY = 4000;

const at = seat();

/** When a STOP was out, by the log file. */
function stops(home: string): number[] {
  const folder = join(home, "data", "wirebend", "state", "log");
  const lines = readdirSync(folder).flatMap((name) => readFileSync(join(folder, name), "utf8").split("\n"));
  return lines.filter((line) => / STOP /.test(line)).map((line) => Date.parse(line.trim().split(/\s+/)[0] ?? ""));
}

it("stops the machine by its key while the page is too busy to hear of it", async () => {
  const driven = await Driven.open(at.unpacked.window, at.screen.display);
  try {
    await driven.click(button("Skip")).catch(() => {});
    await driven.click(button("All examples"));
    await driven.click("//dialog//button[contains(@class,'card')][.//*[normalize-space(.)='House']]");
    const checked =
      "/to look at|within limits/.test(document.querySelector('#section-check .section-phrase')?.innerText)";
    await driven.until(checked, "the house is within the limits");
    // In real time: at ten times the speed a hundredth of a second in which this computer is busy counts as a cable that was cut.
    await driven.homes("sim");
    await driven.click(`//section[@id='section-run']${button("Arm…")}`);
    await driven.click(button("Arm"));
    await driven.click(`//section[@id='section-run']${button("Start")}`);
    await driven.until(says("bending the wire"), "the wire is begun");

    await driven.run(
      `window.begun = 0;
       setTimeout(() => { window.begun = Date.now(); while (Date.now() - window.begun < arguments[0]); window.over = Date.now(); }, 200);`.replace(
        "arguments[0]",
        String(BUSY),
      ),
    );
    await new Promise((resolve) => setTimeout(resolve, 1000));
    const environment = { ...process.env, DISPLAY: at.screen.display };
    const [window = ""] = execFileSync("xdotool", ["search", "--onlyvisible", "--class", "wirebend-kit"], {
      env: environment,
      encoding: "utf8",
    })
      .trim()
      .split("\n");
    execFileSync("xdotool", ["windowfocus", "--sync", window], { env: environment });
    execFileSync("xdotool", ["key", "ctrl+space"], { env: environment });

    await driven.until("window.over", "the page is free again");
    const [begun, over] = await driven.run<[number, number]>("return [window.begun, window.over]");
    await driven.until(says("topped"), "the page shows the stop");
    const [stop = NaN] = stops(driven.home);
    expect(stop).toBeGreaterThan(begun);
    expect(stop).toBeLessThan(over);
  } finally {
    await driven.end();
  }
});
