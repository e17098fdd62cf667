import { platform } from "../platform";
import { openFirst, openNext } from "../state/files/beginning";
import { mayClose } from "../state/files/closing";
import { useFiles } from "../state/files/files";
import { type End, together } from "./changes";
import { takeTyped } from "./typed";

/** What comes from outside the window: files that are dropped or opened elsewhere, and that it is to be closed. */
export function listenToSystem(): End {
  return together([
    platform.onDrop((drop) => {
      useFiles.setState({ over: drop.kind === "over" });
      if (drop.kind === "dropped") void openFirst(drop.paths);
    }),
    platform.onOpen((path) => void openNext(path)),
    platform.onClose(() => {
      takeTyped();
      return mayClose();
    }),
  ]);
}
