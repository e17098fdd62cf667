import type { Theme } from "./ui";

/** Whether the system is set to a light theme; it reports when that changes. */
export const systemTheme = (): MediaQueryList => window.matchMedia("(prefers-color-scheme: light)");

/** The theme that is shown: the system's where the person has chosen none. */
export function shownTheme(theme: Theme): "dark" | "light" {
  if (theme !== "system") return theme;
  return systemTheme().matches ? "light" : "dark";
}
