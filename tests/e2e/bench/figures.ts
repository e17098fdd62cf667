import { mkdirSync, writeFileSync } from "node:fs";
import { root } from "../support/places.ts";

/** Where the figures of a run are kept until all are there. */
export const folder = `${root}target/e2e/figures`;

/** One line of the table. */
export interface Figure {
  readonly what: string;
  readonly measured: string;
  /** What it should be; null where it only says what a figure is made of. */
  readonly aim: string | null;
}

/** Figures that were measured together. */
export interface Figures {
  readonly title: string;
  readonly rows: readonly Figure[];
  /** What has to be known to read them. */
  readonly notes: readonly string[];
}

/** Hands figures over to the table, in which they come in the order of their names. */
export function hand(name: string, figures: Figures): void {
  mkdirSync(folder, { recursive: true });
  writeFileSync(`${folder}/${name}.json`, JSON.stringify(figures));
}

/** What this part of the values stays within, by nearest rank; `part` from 0 to 1. */
export function within(values: readonly number[], part: number): number {
  const sorted = values.toSorted((a, b) => a - b);
  const found = sorted[Math.max(Math.ceil(sorted.length * part) - 1, 0)];
  if (found === undefined) throw new Error("nothing was measured");
  return found;
}

export const median = (values: readonly number[]): number => within(values, 0.5);

export const ms = (value: number): string => `${value.toFixed(value < 10 ? 2 : 1)} ms`;
export const seconds = (ms: number): string => `${(ms / 1000).toFixed(2)} s`;
export const megabytes = (bytes: number): string => `${(bytes / 1e6).toFixed(1)} MB`;
