import { platform } from "../platform";
import { useDesign } from "../state/design/design";
import { shownTheme, systemTheme } from "../state/window/theme";
import { keepUi, useUi } from "../state/window/ui";
import { useUnits } from "../state/window/units";
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

function title(): void {
  const { state } = useDesign.getState();
  if (state) platform.setTitle(`${state.changed ? "\u2022 " : ""}${state.name || "New design"} \u2013 WireBend-kit`);
}

/** How the window looks: as the person has chosen, which is kept, and as the system and the open design say. */
export function followWindow(): End {
  paint();
  measure();
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
      ({ unit }, before) => gridFollows(unit, before.unit),
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
