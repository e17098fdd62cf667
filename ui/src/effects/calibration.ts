import { refreshSheet } from "../state/calibration/calibration";
import type { End } from "./changes";

/** The sheet is a file, which a person may fill in elsewhere: it is read anew when they come back to the window. */
export function followSheet(): End {
  const back = new AbortController();
  window.addEventListener("focus", () => void refreshSheet(), { signal: back.signal });
  return () => back.abort();
}
