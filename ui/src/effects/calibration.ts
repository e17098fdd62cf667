import { refreshSheet, useCalibration } from "../state/calibration/calibration";
import { type End, together, whenChanged } from "./changes";

/** The sheet is a file, which a person may fill in elsewhere: it is read anew when they come to its table or back to the window. */
export function followSheet(): End {
  const back = new AbortController();
  window.addEventListener("focus", () => void refreshSheet(), { signal: back.signal });
  return together([
    () => back.abort(),
    whenChanged(
      useCalibration,
      ({ open, step }) => [open && step === "measure"],
      ({ open, step }) => {
        if (open && step === "measure") void refreshSheet();
      },
    ),
  ]);
}
