import { Loopback } from "./loopback";
import type { Platform } from "./platform";
import { TauriWindow } from "./tauri";

export { type AskName, type FileKind, type Platform, Refused, type WindowEvent } from "./platform";

function environment(): Platform {
  if ("__TAURI_INTERNALS__" in window) return new TauriWindow();
  const token = new URLSearchParams(window.location.search).get("token");
  return new Loopback(token ?? "");
}

/** The environment of this window. */
export const platform: Platform = environment();
