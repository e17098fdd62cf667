import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { button, Driven, inside, says, section } from "../support/installed.ts";
import { pictures } from "../support/places.ts";
import { seat } from "../support/seat.ts";

const at = seat();

function picture(name: string): void {
  mkdirSync(pictures, { recursive: true });
  writeFileSync(`${pictures}/installed-${name}.png`, at.screen.picture());
}

describe("the package", () => {
  it("holds the window, the command line, drivers and what the desktop needs", () => {
    const { folder } = at.unpacked;
    for (const file of [
      "usr/bin/wirebend-kit",
      "usr/bin/wirebend",
      "usr/share/mime/packages/wirebend-kit.xml",
      "usr/share/applications/wirebend-kit.desktop",
    ]) {
      expect(existsSync(`${folder}/${file}`), file).toBe(true);
    }
    const desktop = readFileSync(`${folder}/usr/share/applications/wirebend-kit.desktop`, "utf8");
    expect(desktop).toContain("MimeType=application/x-wirebend");
    expect(desktop).toMatch(/^Exec=wirebend-kit %f$/m);
  });

  it("has its drivers beside it, which its command line runs", () => {
    const [program = "", ...words] = [...inside(), at.unpacked.commands, "drivers", "--json"];
    const drivers = JSON.parse(
      execFileSync(program, words, {
        encoding: "utf8",
        env: { ...process.env, HOME: "/tmp", XDG_CONFIG_HOME: "/tmp" },
      }),
    );
    const states = drivers.drivers.map(({ id, state }: { id: string; state: string }) => [id, state]);
    expect(states.sort()).toEqual(
      ["grbl", "howtomechatronics", "pensa", "tables", "wirebend-kit"].map((id) => [id, "shipped"]),
    );
  });
});

describe("the window of the package", () => {
  it("goes from an example over a fix and the animation to a wire on the simulated machine and a file", async () => {
    const driven = await Driven.open(at.unpacked.window, at.screen.display);
    try {
      // An example.
      await driven.click(button("Skip")).catch(() => {});
      await driven.click(button("All examples"));
      await driven.click("//button[contains(@class,'card')][.//*[normalize-space(.)='Truss']]");
      await driven.until(says("1 to fix"), "the truss has something to fix");
      picture("1-red");

      // A fix.
      await driven.click(button("Fix…"));
      await driven.click(button("Apply"));
      await driven.until(`!(${says("1 to fix")})`, "the fix has corrected it");
      picture("2-fixed");

      // The animation.
      await driven.click(section("Animate"));
      const position = "Number(document.querySelector('.timeline input[type=range]').value)";
      await driven.until("document.querySelector('.timeline input[type=range]:enabled')", "there is a program");
      await driven.click("//section[@aria-label='Timeline']//button[@aria-label='Play']");
      await driven.until(`${position} > 0`, "it plays");
      await driven.click("//section[@aria-label='Timeline']//button[@aria-label='Pause']");
      const held = await driven.run<number>(`return ${position}`);
      expect(held).toBeGreaterThan(0);
      picture("3-animated");

      // The truss hits itself while it is bent. What Check says of it comes once the search ends, and moves what is below it.
      await driven.until(says("The wire hits itself"), "the collision is found", 100_000);

      // The simulated machine.
      // What the machine says of itself comes later than the buttons that move it, which stay where they are.
      await driven.run(
        `window.tops = new Set();
         (function look() {
           const section = document.querySelector("#section-run");
           for (const button of section.querySelectorAll("button"))
             if (button.textContent.trim() === "Home")
               window.tops.add(Math.round(button.getBoundingClientRect().top - section.getBoundingClientRect().top));
           requestAnimationFrame(look);
         })();`,
      );
      await driven.homes("sim:max");
      expect(await driven.run("return [...window.tops]")).toHaveLength(1);
      // A person goes on all the same.
      await driven.click("//section[@id='section-run']//label[contains(.,'Bend it anyway')]");
      await driven.click(`//section[@id='section-run']${button("Arm…")}`);
      picture("4-armed");
      await driven.click(button("Arm"));
      await driven.click(`//section[@id='section-run']${button("Start")}`);
      await driven.until(says("The wire is finished"), "the wire is finished", 100_000);
      picture("5-made");

      // A file.
      const file = `${driven.home}/truss.txt`;
      await driven.click(section("Export"));
      // What comes after it moves when it comes.
      await driven.until(
        "document.querySelector('#section-export .preview pre')",
        "the beginning of the file is shown",
      );
      const field = "//section[@id='section-export']//input[@placeholder='choose a place']";
      await driven.until(
        `document.evaluate(${JSON.stringify(field)}, document, null, 9, null).singleNodeValue`,
        "there is a place for the file",
      );
      const found = await driven.client.findElement("xpath", field);
      const id = found["element-6066-11e4-a52e-4f735466cecf"];
      await driven.client.elementSendKeys(id, `${driven.seen}/truss.txt`);
      await driven.click("//section[@id='section-export']//label[contains(.,'Write it anyway')]");
      await driven.click(`//section[@id='section-export']${button("Write")}`);
      await driven.until(says("truss.txt"), "the file is named");
      await expect.poll(() => existsSync(file)).toBe(true);
      expect(readFileSync(file, "utf8")).toMatch(/^F \d+\.\d{3}$/m);
      picture("6-exported");
    } finally {
      await driven.end();
    }
  });

  it("comes onto the screen when it was left on a larger one", async () => {
    const left = { x: 1300, y: 700, width: 2400, height: 1300 };
    const driven = await Driven.open(at.unpacked.window, at.screen.display, [], left);
    try {
      const whole = "innerWidth === 1440 && innerHeight === 900 && screenX === 0 && screenY === 0";
      await driven.until(whole, "all of it is on the screen");
    } finally {
      await driven.end();
    }
  });
});
