import { create } from "zustand";
import type { ViewAxes } from "../../scene/interface";

/** How the view is turned; null before it was drawn. Apart from `useView`: it is another at every frame of a turn. */
export const useViewAxes = create<{ readonly axes: ViewAxes | null }>()(() => ({ axes: null }));
