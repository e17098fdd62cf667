import type { Colour } from "../../scene/interface";

const rgb = (hex: number): Colour => [(hex >> 16) / 255, ((hex >> 8) & 255) / 255, (hex & 255) / 255];

/** From nothing to the most: seen on a dark ground and on a light one, and told apart by those who do not see red and green. */
const RISING: readonly Colour[] = [rgb(0x4a7bd0), rgb(0x8c64d6), rgb(0xd65496), rgb(0xff8a4c)];

/** Compression, nothing, tension. */
const DIVERGING: readonly Colour[] = [rgb(0xe8603c), rgb(0x8f98a3), rgb(0x3f8cff)];

/** Where a figure is not known. */
export const UNKNOWN: Colour = rgb(0x7d8793);

function between(colours: readonly Colour[], share: number): Colour {
  const place = Math.min(Math.max(share, 0), 1) * (colours.length - 1);
  const index = Math.min(Math.floor(place), colours.length - 2);
  const [a, b] = [colours[index] ?? UNKNOWN, colours[index + 1] ?? UNKNOWN];
  const part = place - index;
  return [a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part, a[2] + (b[2] - a[2]) * part];
}

/** Of a share from 0 to 1. */
export const rising = (share: number): Colour => between(RISING, share);

/** Of a share from −1, compression, to 1, tension; 0 is grey. */
export const diverging = (share: number): Colour => between(DIVERGING, (share + 1) / 2);

const css = (colour: Colour): string => `rgb(${colour.map((part) => Math.round(part * 255)).join(" ")})`;

/** The same for a legend, from its left to its right. */
export const gradientOf = (kind: "rising" | "diverging"): string =>
  `linear-gradient(to right, ${(kind === "rising" ? RISING : DIVERGING).map(css).join(", ")})`;

/** Layers, one after the other: neighbours are told apart, and none is the blue of what is being built. */
const LAYERS: readonly Colour[] = [0x35a7a0, 0xff8a4c, 0x8c64d6, 0xb59a2d, 0xd65496, 0x6f9a4c].map(rgb);

export const layerColour = (layer: number): Colour => LAYERS[layer % LAYERS.length] ?? UNKNOWN;

export const cssOf = css;
