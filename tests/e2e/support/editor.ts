import { readFileSync } from "node:fs";
import { basename } from "node:path";
import type { Browser, Locator, Page } from "playwright-core";
import { expect } from "vitest";
import type { DesignView, MachineState } from "../../../ui/src/generated/responses.ts";
import { barriers, type Complaints, openBrowser, openPage, picture } from "./browser.ts";
import { Loopback } from "./loopback.ts";

export type Section =
  | "parts"
  | "trace"
  | "edit"
  | "check"
  | "animate"
  | "frame"
  | "sequence"
  | "machine"
  | "export"
  | "run";

/** How long something may take on a computer that is busy, ms. */
export const PATIENCE = Number(process.env.E2E_PATIENCE_MS ?? 30_000);

/** Waits until something is as it should be. */
export const until = <T>(look: () => T | Promise<T>) => expect.poll(look, { timeout: PATIENCE, interval: 40 });

/** The editor in a browser, and the Rust side behind it. */
export class Editor {
  /** Clicks and keys of a test that counts them. */
  handled = 0;

  private constructor(
    public loopback: Loopback,
    private readonly browser: Browser,
    readonly page: Page,
    private readonly complaints: Complaints,
  ) {
    page.setDefaultTimeout(PATIENCE);
  }

  /** `before`: what is to be in the home before it starts; `browserArguments`: arguments for the browser beside the usual ones. */
  static async open(
    options: Parameters<typeof openPage>[2] = {},
    before: (home: string) => void = () => {},
    browserArguments: readonly string[] = [],
  ): Promise<Editor> {
    const home = Loopback.home();
    before(home);
    const loopback = await Loopback.start(home);
    const browser = await openBrowser(browserArguments);
    const [page, complaints] = await openPage(browser, loopback.url, options);
    const editor = new Editor(loopback, browser, page, complaints);
    await editor.ready();
    return editor;
  }

  async end(): Promise<void> {
    await this.browser.close();
    await this.loopback.end();
  }

  /** The Rust side is killed and started again on what it has left, and the window with it. */
  async crash(): Promise<void> {
    await this.page.goto("about:blank");
    await this.loopback.kill();
    this.loopback = await Loopback.start(this.loopback.home);
    await this.page.goto(this.loopback.url);
    await this.ready();
  }

  /** Until the window shows the open design, and the view is there. */
  async ready(): Promise<void> {
    await this.page.locator(".viewport canvas").waitFor();
    await this.page.getByRole("contentinfo", { name: "Status" }).getByText(/saved/).waitFor();
  }

  /** Begins with an example, and these sections open. What was open before is gone. */
  async take(example: string | null, ...sections: Section[]): Promise<void> {
    if (example === null) await this.loopback.ask("new", {});
    else await this.loopback.ask("open-example", { id: example });
    await this.reload(...sections);
    if (example !== null)
      await this.section("edit")
        .locator(".section-phrase", { hasText: /vert|empty/ })
        .waitFor();
  }

  async reload(...sections: Section[]): Promise<void> {
    await this.page.evaluate((open) => localStorage.setItem("wirebend.ui", JSON.stringify({ open })), sections);
    // The window writes down how it stands when it changes: nothing does between these two.
    await this.page.reload();
    await this.ready();
  }

  section(id: Section): Locator {
    return this.page.locator(`#section-${id}`);
  }

  /** What the header of a section says of its state. */
  async phrase(id: Section): Promise<string> {
    return (await this.section(id).locator(".section-phrase").innerText()).replaceAll(/\s+/g, " ").trim();
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole("button", typeof name === "string" ? { name, exact: true } : { name });
  }

  /** Chooses from the menus at the top: menu, entry, entry of a submenu. */
  async menu(...names: readonly string[]): Promise<void> {
    const [menu = "", ...items] = names;
    await this.page.getByRole("menubar").getByRole("menuitem", { name: menu, exact: true }).click();
    for (const item of items)
      await this.page
        .getByRole("menu")
        .getByRole(/^(Dark|Light|As the system|Millimetres|Inches)$/.test(item) ? "menuitemradio" : "menuitem", {
          name: item,
        })
        .first()
        .click();
  }

  /** The design as the Rust side has it. */
  async design(): Promise<DesignView> {
    return (await this.loopback.ask("start", {})).design;
  }

  /** Presses keys one after the other, which count. */
  async keys(...pressed: readonly string[]): Promise<void> {
    for (const key of pressed) {
      this.handled += 1;
      await this.page.keyboard.press(key);
    }
  }

  /** How the machine stands that is connected. */
  async machine(): Promise<MachineState> {
    const { state } = await this.loopback.ask("machine-state", {});
    if (!state) throw new Error("no machine is connected");
    return state;
  }

  /**
   * Once the wire is being bent, has it bent at so many per cent of its speed, not by the buttons of the window: a simulated machine at ten times
   * the speed is done before a busy computer has seen what it looks for.
   */
  async atSpeed(percent: number): Promise<void> {
    await until(async () => (await this.machine()).phase).toMatch(/^(making|holding)$/);
    await this.loopback.ask("order", { request: { order: "speed", percent } });
    await until(async () => (await this.machine()).speed_percent).toBe(percent);
  }

  /** Where a vertex is, mm. */
  async vertex(id: number): Promise<readonly [number, number, number]> {
    const found = (await this.design()).vertices.find((vertex) => vertex.id === id);
    if (!found) throw new Error(`there is no vertex ${id}`);
    return found.at_mm;
  }

  /** Drops a file on the window, as a person does from a folder. */
  async drop(file: string, contents: Buffer | string = readFileSync(file)): Promise<void> {
    const bytes = [...Buffer.from(contents)];
    await this.page.evaluate(
      ({ name, bytes }) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([new Uint8Array(bytes)], name));
        for (const type of ["dragover", "drop"])
          window.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
      },
      { name: basename(file), bytes },
    );
  }

  /** Answers the dialog of the system with files, once something has asked for it. */
  async choose(file: string, ask: () => Promise<unknown>): Promise<void> {
    const [chooser] = await Promise.all([this.page.waitForEvent("filechooser"), ask()]);
    await chooser.setFiles(file);
  }

  /** What is shown over the view. */
  get messages(): Locator {
    return this.page.getByLabel("Messages").getByRole("listitem");
  }

  /** The same in the theme that is shown, for what is on the way to somewhere else. */
  isCleanNow(name: string): Promise<void> {
    return this.isClean(name, ["dark"]);
  }

  /** Nothing went wrong unexpectedly, and no user is kept out, in both themes. The second is looked at for its colours: they differ in nothing else. */
  async isClean(name: string, themes: readonly ("dark" | "light")[] = ["dark", "light"]): Promise<void> {
    for (const scheme of themes) {
      await this.page.emulateMedia({ colorScheme: scheme });
      await until(() => this.page.evaluate(() => document.documentElement.dataset.theme)).toBe(scheme);
      const rules = scheme === themes[0] ? "all" : "of colours";
      expect(await barriers(this.page, rules), `barriers of ${name} in ${scheme}`).toEqual([]);
      await picture(this.page, `${name}-${scheme}`);
    }
    await this.page.emulateMedia({ colorScheme: "dark" });
    expect(this.complaints.list).toEqual([]);
  }
}
