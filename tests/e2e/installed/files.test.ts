import { type ChildProcess, execFileSync, spawn } from "node:child_process";
import { copyFileSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Driven, inRoot, inside, says } from "../support/installed.ts";
import { root } from "../support/places.ts";
import { seat } from "../support/seat.ts";

const at = seat();
let bus: ChildProcess;
let folder: string;

beforeAll(async () => {
  // Windows find each other by the bus of the session.
  bus = spawn("dbus-daemon", ["--session", "--print-address=1", "--nofork"], { stdio: ["ignore", "pipe", "ignore"] });
  const address = await new Promise<string>((resolve, reject) => {
    bus.on("error", reject);
    bus.stdout?.once("data", (line: Buffer) => resolve(line.toString().trim()));
  });
  process.env.DBUS_SESSION_BUS_ADDRESS = address;
  folder = mkdtempSync(join(inRoot ? `${inRoot}/tmp` : tmpdir(), "wirebend-files-"));
});

afterAll(async () => {
  bus.kill();
  rmSync(folder, { recursive: true, force: true });
});

/** A file that the user of the window can read; as the window sees it. */
function put(example: string, name: string): string {
  const path = join(folder, name);
  copyFileSync(`${root}examples/${example}`, path);
  if (inRoot) execFileSync("chmod", ["-R", "a+rX", folder]);
  return inRoot ? path.slice(inRoot.length) : path;
}

it("opens the file that it is started with, and the file of a second start in the same window", async () => {
  const driven = await Driven.open(at.unpacked.window, at.screen.display, [put("house.obj", "first house.obj")]);
  try {
    await driven.until(says("first house"), "the file is open");
    const [program = "", ...words] = [...inside(), at.unpacked.window, put("spring.obj", "a spring.obj")];
    const second = spawn(program, words, { stdio: "inherit", env: driven.environment });
    const status = await new Promise((resolve) => second.once("exit", resolve));
    expect(status).toBe(0);
    await driven.until(says("a spring"), "the second file is open");
  } finally {
    await driven.end();
  }
});
