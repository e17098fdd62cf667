import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { type Browser, chromium, type Page } from "playwright-core";
import { watch } from "./movements.ts";
import { pictures } from "./places.ts";
import { watchesWaits } from "./still.ts";
import { TELL, type Watched, watchPointer } from "./under_pointer.ts";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Where it is on Debian; Ubuntu has it as a snap alone, which sees no files of the tests. */
const BROWSERS = ["/usr/bin/chromium", "/usr/bin/google-chrome"];

/**
 * The page is put together by what draws in three dimensions too, as on a graphics card: what `bench` measures. On the processor it costs
 * tests a third more.
 */
export const COMPOSITED = "--use-angle=swiftshader";

/** Edges of what it draws in three dimensions are smooth, as on a graphics card. On the processor a frame costs a quarter more. */
export const SMOOTH = "--webgl-antialiasing-mode=explicit";

/** Chromium without a screen; what it draws in three dimensions is computed by the processor, and not smoothed unless it is asked to. */
export function openBrowser(more: readonly string[] = []): Promise<Browser> {
  const args = [
    "--no-sandbox",
    "--enable-unsafe-swiftshader",
    "--webgl-antialiasing-mode=none",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
    ...more,
  ];
  const executablePath = BROWSERS.find((path) => existsSync(path)) ?? BROWSERS[0];
  return chromium.launch({ executablePath, headless: true, args });
}

/** What a page complained of that was not expected. */
export interface Complaints {
  readonly list: string[];
}

/** A page that keeps what it complains of: a mistake in a script fails the test that caused it. */
export async function openPage(
  browser: Browser,
  url: string,
  { width = 1280, height = 800, scheme = "dark" as "dark" | "light", hints = false } = {},
): Promise<[Page, Complaints]> {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: scheme,
    acceptDownloads: false,
  });
  const page = await context.newPage();
  const complaints: Complaints = { list: [] };
  const movements: string[] = [];
  const unwatch = watch(async () => {
    // A page that is left for another one has no pointer any more.
    await page.evaluate(() => (globalThis as Watched).wirebendPointer?.rest()).catch(() => undefined);
    return movements.splice(0);
  });
  page.on("close", () => void unwatch());
  await page.exposeBinding(TELL, (_, what: string) => void movements.push(what));
  await page.addInitScript(watchPointer, TELL);
  await watchesWaits(page);
  page.on("pageerror", (error) => complaints.list.push(error.message));
  page.on("console", (message) => {
    // A refusal is an answer, and the person is shown it.
    if (message.type() === "error" && !message.text().includes("422")) complaints.list.push(message.text());
  });
  // An empty page has no storage.
  if (!hints)
    await page.addInitScript(
      () => void (location.protocol === "http:" && localStorage.setItem("wirebend.hints", "seen")),
    );
  await page.goto(url);
  return [page, complaints];
}

export interface Violation {
  readonly id: string;
  readonly impact: string | null;
  readonly nodes: readonly string[];
}

interface Axe {
  run(options: object): Promise<{ violations: Found[] }>;
  getRules(tags: readonly string[]): { ruleId: string; tags: string[] }[];
}

/** As axe reports it. */
interface Found {
  readonly id: string;
  readonly impact: string | null;
  readonly nodes: readonly { readonly html: string }[];
}

/** What axe finds that keeps people out, by all of its rules or by those of its category of colours. */
export async function barriers(page: Page, rules: "all" | "of colours"): Promise<Violation[]> {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(axe);
  return page.evaluate(async (rules) => {
    const { axe } = window as unknown as { axe: Axe };
    // What the category has beyond that is off where all rules are asked for.
    const ofColours = axe.getRules(["cat.color"]).filter(({ tags }) => !tags.includes("wcag2aaa"));
    const runOnly = rules === "all" ? {} : { runOnly: ofColours.map(({ ruleId }) => ruleId) };
    const { violations } = await axe.run({ resultTypes: ["violations"], ...runOnly });
    return violations
      .filter(({ impact }) => impact === "serious" || impact === "critical")
      .map(({ id, impact, nodes }) => ({
        id,
        impact,
        nodes: nodes.map((node) => node.html.slice(0, 160)),
      }));
  }, rules);
}

/** Keeps a picture of the page for people to look at, packed fast: packing it well took a tenth of the time of all tests. */
export async function picture(page: Page, name: string): Promise<void> {
  mkdirSync(pictures, { recursive: true });
  const session = await page.context().newCDPSession(page);
  try {
    const { data } = await session.send("Page.captureScreenshot", { format: "png", optimizeForSpeed: true });
    writeFileSync(`${pictures}/${name}.png`, data, "base64");
  } finally {
    await session.detach();
  }
}
