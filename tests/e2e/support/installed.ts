import { type ChildProcess, execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import WebDriver, { type Client } from "webdriver";
import { watch } from "./movements.ts";
import { root } from "./places.ts";
import { TELL, watchPointer } from "./under_pointer.ts";

/** The package, unpacked as it is installed: the same paths below a folder of its own. */
export interface Unpacked {
  readonly folder: string;
  /** The window's program. */
  readonly window: string;
  /** The command line. */
  readonly commands: string;
  readonly bytes: number;
}

/** Deletes what was unpacked; what was installed stays. */
export function discard({ folder }: Unpacked): void {
  if (folder !== inRoot) rmSync(folder, { recursive: true, force: true });
}

/** The .deb that `make package` wrote. */
export function deb(): string {
  const folder = `${root}target/package`;
  const found = readdirSync(folder).filter((name) => name.endsWith(".deb"));
  if (found.length !== 1) throw new Error(`${folder} holds ${found.length} packages: run make package`);
  return join(folder, found[0] ?? "");
}

/** Where a window is on its screen. */
interface Place {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Another root file system, in which the package was installed, and who is to use it there. */
export const inRoot = process.env.WIREBEND_ROOT;
const user = process.env.WIREBEND_USER;

export function unpack(): Unpacked {
  if (inRoot)
    return {
      folder: inRoot,
      window: "/usr/bin/wirebend-kit",
      commands: "/usr/bin/wirebend",
      bytes: statSync(deb()).size,
    };
  const folder = mkdtempSync(join(tmpdir(), "wirebend-deb-"));
  execFileSync("dpkg-deb", ["--extract", deb(), folder]);
  return {
    folder,
    window: `${folder}/usr/bin/wirebend-kit`,
    commands: `${folder}/usr/bin/wirebend`,
    bytes: statSync(deb()).size,
  };
}

/** The button of this name that can be pressed. */
export const button = (name: string): string =>
  `//button[normalize-space(.)=${JSON.stringify(name)} and not(@aria-disabled='true') and not(@disabled)]`;
/** The header of a section that is closed. */
export const section = (name: string): string =>
  `//section//h2/button[@aria-expanded='false'][.//*[normalize-space(.)=${JSON.stringify(name)}]]`;
/** A script of the page: whether this is to be read on it. */
export const says = (text: string): string => `document.body.innerText.includes(${JSON.stringify(text)})`;

/** What runs a program where the package is installed. */
export function inside(): string[] {
  if (!inRoot) return [];
  return ["chroot", ...(user ? [`--userspec=${user}:${user}`] : []), inRoot];
}

async function freePort(): Promise<number> {
  const server = createServer();
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  const address = server.address();
  await new Promise((resolve) => server.close(resolve));
  if (address === null || typeof address === "string") throw new Error("there is no free port");
  return address.port;
}

/** The window, driven through WebKit's own driver. */
export class Driven {
  /** Ends the measuring of what moves under its pointer. */
  private unwatch = async (): Promise<void> => {};

  private constructor(
    private readonly child: ChildProcess,
    readonly client: Client,
    /** The home of its user. */
    readonly home: string,
    /** The same as the window sees it. */
    readonly seen: string,
    /** What the window's process has around it. */
    readonly environment: NodeJS.ProcessEnv,
  ) {}

  /** Opens the window on a screen, for a person with a home of their own; `left`: where it was when it was closed, px. */
  static async open(window: string, display: string, words: string[] = [], left?: Place): Promise<Driven> {
    const home = mkdtempSync(join(inRoot ? `${inRoot}/tmp` : tmpdir(), "wirebend-home-"));
    if (left) {
      const folder = join(home, "config/org.wirebend.kit");
      mkdirSync(folder, { recursive: true });
      const rest = {
        prev_x: left.x,
        prev_y: left.y,
        maximized: false,
        visible: true,
        decorated: true,
        fullscreen: false,
      };
      writeFileSync(join(folder, ".window-state.json"), JSON.stringify({ main: { ...left, ...rest } }));
    }
    if (user) execFileSync("chown", ["-R", `${user}:${user}`, home]);
    const port = await freePort();
    const driver = ["WebKitWebDriver", `--port=${port}`, "--host=127.0.0.1"];
    const [program = "", ...rest] = [...inside(), ...driver];
    const seen = inRoot ? home.slice(inRoot.length) : home;
    const environment = {
      ...process.env,
      HOME: seen,
      XDG_CONFIG_HOME: `${seen}/config`,
      XDG_DATA_HOME: `${seen}/data`,
      XDG_CACHE_HOME: `${seen}/cache`,
      DISPLAY: display,
      // The toolkit lets itself be driven only where it is set so.
      TAURI_AUTOMATION: "true",
      TAURI_WEBVIEW_AUTOMATION: "true",
    };
    const child = spawn(program, rest, { stdio: ["ignore", "inherit", "inherit"], env: environment });
    await answers(port);
    const client = await WebDriver.newSession({
      hostname: "127.0.0.1",
      port,
      logLevel: "error",
      connectionRetryCount: 0,
      capabilities: {
        alwaysMatch: { "webkitgtk:browserOptions": { binary: window, args: words } },
        firstMatch: [{}],
      } as never,
    });
    const driven = new Driven(child, client, home, seen, environment);
    await driven.watch();
    return driven;
  }

  /** Measures what moves under the pointer, by the same as in a browser. */
  private async watch(): Promise<void> {
    await this.until("document.querySelector('.viewport canvas')", "the window is there");
    // As text of the script: the page does not let its own texts be run.
    await this.run(
      `window.wirebendMovements = [];
       window[arguments[0]] = async (what) => void window.wirebendMovements.push(what);
       (${watchPointer})(arguments[0]);`,
      TELL,
    );
    const rest =
      "const done = arguments[0]; window.wirebendPointer.rest().then(() => done(window.wirebendMovements.splice(0)))";
    this.unwatch = watch(() => this.client.executeAsyncScript(rest, []) as Promise<string[]>);
  }

  /** Runs a function in the page. */
  run<T>(script: string, ...words: unknown[]): Promise<T> {
    return this.client.executeScript(script, words as object[]) as Promise<T>;
  }

  /** Waits until a script of the page says yes. */
  async until(script: string, what: string, patience = 30_000): Promise<void> {
    const begun = Date.now();
    while (!(await this.run<boolean>(`return Boolean(${script})`))) {
      if (Date.now() - begun > patience) {
        const page = await this.run<string>("return document.body.innerText");
        throw new Error(`after ${patience / 1000} s still not: ${what}; the page says:\n${page}`);
      }
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }

  /** Clicks what is there, or will be. */
  async click(xpath: string): Promise<void> {
    const first = `document.evaluate(${JSON.stringify(xpath)}, document, null, 9, null).singleNodeValue`;
    await this.until(first, `there is ${xpath}`);
    // What cannot be done yet says so, and does nothing when it is clicked.
    await this.until(`${first}?.getAttribute("aria-disabled") !== "true"`, `it can be clicked: ${xpath}`);
    // A part of the panel that is scrolled away cannot be clicked.
    await this.run(`const found = ${first}; if (found) window.wirebendPointer.bring(found)`);
    const found = await this.client.findElement("xpath", xpath);
    if ("error" in found) throw new Error(`it was there and has gone: ${xpath}`);
    await this.client.elementClick(found["element-6066-11e4-a52e-4f735466cecf"]);
  }

  /** Connects a simulated machine and homes it. */
  async homes(port: string): Promise<void> {
    await this.click(section("Run"));
    await this.choose("#section-run select", port);
    await this.click(button("Connect"));
    await this.click(`//section[@id='section-run']${button("Home")}`);
    // It can be armed before, and not while it homes.
    await this.until(says("simulated machine · homed"), "the machine is homed", 100_000);
  }

  /** Chooses of a list, which the system draws where no driver reaches it. */
  async choose(selector: string, value: string): Promise<void> {
    await this.until(
      `[...(document.querySelector(${JSON.stringify(selector)})?.options ?? [])].some((one) => one.value === ${JSON.stringify(value)})`,
      `${selector} has ${value}`,
    );
    await this.run(
      `const list = document.querySelector(arguments[0]);
       Object.getOwnPropertyDescriptor(HTMLSelectElement.prototype, "value").set.call(list, arguments[1]);
       list.dispatchEvent(new Event("change", { bubbles: true }));`,
      selector,
      value,
    );
  }

  async end(): Promise<void> {
    try {
      await this.unwatch();
    } finally {
      // Without it the driver leaves the window behind.
      await this.client.deleteSession().catch(() => {});
      const over = new Promise((resolve) => this.child.once("close", resolve));
      this.child.kill();
      await over;
      rmSync(this.home, { recursive: true, force: true });
    }
  }
}

/** Waits until something listens at a port. */
async function answers(port: number): Promise<void> {
  for (let tries = 0; tries < 200; tries += 1) {
    try {
      await fetch(`http://127.0.0.1:${port}/status`);
      return;
    } catch {
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }
  throw new Error("the driver of the window does not answer");
}
