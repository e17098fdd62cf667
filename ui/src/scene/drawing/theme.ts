/** Colours of the scene. Colour means the same as in the panels: red cannot be made, amber is near a limit, green is fine, blue is acted on. */

export type ThemeName = "dark" | "light";

/** Red, green, blue as the screen takes them, 0 to 1. */
export type Rgb = readonly [number, number, number];

export interface Theme {
  /** Middle and rim of the backdrop. */
  readonly backCentre: Rgb;
  readonly backEdge: Rgb;
  /** Ambient, from the light, from above. */
  readonly light: readonly [number, number, number];
  /** How much of a far edge goes over into the backdrop. */
  readonly fade: number;
  readonly edge: Rgb;
  readonly vertex: Rgb;
  readonly error: Rgb;
  readonly warning: Rgb;
  readonly fine: Rgb;
  readonly selected: Rgb;
  readonly hovered: Rgb;
  readonly acted: Rgb;
  /** Around symbols, so that they are seen on anything. */
  readonly halo: Rgb;
  readonly made: Rgb;
  readonly stencil: Rgb;
  readonly grid: Rgb;
  readonly axes: readonly [Rgb, Rgb, Rgb];
  readonly machine: { readonly frame: Rgb; readonly head: Rgb; readonly peg: Rgb };
  readonly text: string;
  readonly textBack: string;
}

const rgb = (hex: number): Rgb => [(hex >> 16) / 255, ((hex >> 8) & 255) / 255, (hex & 255) / 255];

/** For style sheets. */
export const css = (colour: Rgb): string => `rgb(${colour.map((part) => Math.round(part * 255)).join(" ")})`;

export const THEMES: Readonly<Record<ThemeName, Theme>> = {
  dark: {
    backCentre: rgb(0x202831),
    backEdge: rgb(0x12161c),
    light: [0.5, 0.42, 0.14],
    fade: 0.62,
    edge: rgb(0xd2d9e3),
    vertex: rgb(0x9aa7b8),
    error: rgb(0xff5f5a),
    warning: rgb(0xffb547),
    fine: rgb(0x45e6a0),
    selected: rgb(0xffdf3a),
    hovered: rgb(0xffffff),
    acted: rgb(0x58a0ff),
    halo: rgb(0x0c0f13),
    made: rgb(0xff9f43),
    stencil: rgb(0x7f93ab),
    grid: rgb(0x8fa3bd),
    axes: [rgb(0xf0616d), rgb(0x6cc04a), rgb(0x4f9dff)],
    machine: { frame: rgb(0x64717f), head: rgb(0x8b99ab), peg: rgb(0x58a0ff) },
    text: "#e8edf3",
    textBack: "rgb(16 20 26 / 0.86)",
  },
  light: {
    backCentre: rgb(0xfafbfc),
    backEdge: rgb(0xe3e8ee),
    light: [0.58, 0.34, 0.12],
    fade: 0.66,
    edge: rgb(0x4a5666),
    vertex: rgb(0x66758a),
    error: rgb(0xd92d2a),
    warning: rgb(0xc87700),
    fine: rgb(0x0f9461),
    selected: rgb(0xf5c400),
    hovered: rgb(0x1f2933),
    acted: rgb(0x1f6feb),
    halo: rgb(0x2b3440),
    made: rgb(0xe07b00),
    stencil: rgb(0x8c9db3),
    grid: rgb(0x6a7c93),
    axes: [rgb(0xd63f4c), rgb(0x3f9a1f), rgb(0x1f6feb)],
    machine: { frame: rgb(0xaeb8c4), head: rgb(0x8d9bac), peg: rgb(0x1f6feb) },
    text: "#17202b",
    textBack: "rgb(255 255 255 / 0.9)",
  },
};
