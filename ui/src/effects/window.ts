import { platform } from "../platform";
import { told } from "../state/asking/problems";
import { checkDesign, useDesign } from "../state/design/design";
import { stopComparing } from "../state/machine/machines";
import { shownTheme, systemTheme } from "../state/window/theme";
import { keepUi, useUi } from "../state/window/ui";
import { type DisplayUnit, useUnits } from "../state/window/units";
import { gridFollows } from "../state/window/view";
import { type End, together, whenChanged } from "./changes";

function paint(): void {
  document.documentElement.dataset.theme = shownTheme(useUi.getState().theme);
}

/** Lengths are shown as the person has chosen, whatever design is open; before that as the design says. */
function measure(): void {
  const own = useDesign.getState().state?.units === "inch" ? "inch" : "mm";
  useUnits.setState({ unit: useUi.getState().unit ?? own });
}

let wording = false;

/**
 * Has messages worded in the unit that is shown. Those that are there stay as they are but for what is asked again: the checks, and what
 * they and the preview of a file are followed by. One question is on its way at a time.
 */
async function word(): Promise<void> {
  if (wording) return;
  wording = true;
  let unit: DisplayUnit;
  do {
    ({ unit } = useUnits.getState());
    await told(platform.ask("show-lengths", { unit }));
  } while (unit !== useUnits.getState().unit);
  wording = false;
  stopComparing();
  checkDesign();
}

function title(): void {
  const { state } = useDesign.getState();
  if (state) platform.setTitle(`${state.changed ? "\u2022 " : ""}${state.name || "New design"} \u2013 WireBend-kit`);
}

/** How the window looks: as the person has chosen, which is kept, and as the system and the open design say. */
export function followWindow(): End {
  paint();
  measure();
  // The Rust side may have been here before the window was, as when that is loaded anew.
  void word();
  const system = systemTheme();
  system.addEventListener("change", paint);
  return together([
    () => system.removeEventListener("change", paint),
    useUi.subscribe(keepUi),
    whenChanged(useUi, ({ theme }) => [theme], paint),
    whenChanged(useUi, ({ unit }) => [unit], measure),
    whenChanged(
      useUnits,
      ({ unit }) => [unit],
      ({ unit }, before) => {
        gridFollows(unit, before.unit);
        void word();
      },
    ),
    whenChanged(
      useDesign,
      ({ state }) => [state],
      ({ state }) => {
        if (state) measure();
        title();
      },
    ),
  ]);
}
