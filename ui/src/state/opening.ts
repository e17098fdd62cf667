import { platform } from "../platform";
import { useUnitStore } from "../shared/unit";
import { mayClose } from "./closing";
import { designReplaced } from "./commands";
import { checked, useDesign } from "./design";
import { openPath, start, useFiles } from "./files";
import { listenToKeys } from "./pressing";
import { tell, told } from "./problems";
import { type Theme, useUi } from "./ui";
import { listen } from "./work";

const light = () => window.matchMedia("(prefers-color-scheme: light)");

/** The theme that is shown: the system's where the person has chosen none. */
export function shownTheme(theme: Theme): "dark" | "light" {
  if (theme !== "system") return theme;
  return light().matches ? "light" : "dark";
}

function paint(): void {
  document.documentElement.dataset.theme = shownTheme(useUi.getState().theme);
}

/** Lengths are shown as the person has chosen, whatever design is open; before that as the design says. */
function measure(): void {
  const own = useDesign.getState().state?.units === "inch" ? "inch" : "mm";
  useUnitStore.setState({ unit: useUi.getState().unit ?? own });
}

async function openFirst(paths: readonly string[]): Promise<void> {
  const [first, ...others] = paths;
  if (!first) return;
  if (others.length > 0) tell("info", `Only the first of ${paths.length} files is opened: one design is open at a time.`, "one-file");
  await openPath(first);
}

/** How long the view waits for what it shows first, ms: a large model comes into a view that is there. */
const PATIENCE = 500;

let beginning: Promise<unknown> = Promise.resolve();

/** Takes up what is open, and what the window was started with. */
async function begin(): Promise<void> {
  const [files] = await Promise.all([told(platform.filesToOpen()), start()]);
  await openFirst(files ?? []);
}

/** When what the window begins with is there and checked, or was waited for long enough: a picture of nothing before it would only cost time. */
export function begun(): Promise<unknown> {
  return Promise.race([beginning.then(checked), new Promise((resolve) => setTimeout(resolve, PATIENCE))]);
}

/** Brings the window to life; the function that is returned ends it. */
export function open(): () => void {
  paint();
  measure();
  const system = light();
  system.addEventListener("change", paint);
  const ends = [
    () => system.removeEventListener("change", paint),
    useUi.subscribe(paint),
    useUi.subscribe(measure),
    listen(),
    listenToKeys(),
    useDesign.subscribe(({ state }, before) => {
      if (state === before.state || !state) return;
      measure();
      platform.setTitle(`${state.changed ? "\u2022 " : ""}${state.name || "New design"} \u2013 WireBend-kit`);
    }),
    platform.onDrop((drop) => {
      useFiles.setState({ over: drop.kind === "over" });
      if (drop.kind === "dropped") void openFirst(drop.paths);
    }),
    // What the window was started with was asked for before.
    platform.onOpen((path) => void beginning.then(() => openPath(path))),
    platform.onClose(mayClose),
    useFiles.subscribe(({ opened }, { opened: before }) => {
      if (opened !== before) designReplaced();
    }),
  ];
  beginning = told(begin());
  return () => ends.forEach((end) => end());
}
