import { existsSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { availableParallelism, loadavg } from "node:os";
import { type Figures, folder } from "./figures.ts";

/** Of the last minute: programs that wanted a processor. */
let before = 0;

/** Figures of an earlier run are none of this one. */
export function setup(): void {
  before = loadavg()[0] ?? 0;
  rmSync(folder, { recursive: true, force: true });
}

/** Prints what the run has measured, as the other benchmarks do. */
export function teardown(): void {
  const names = existsSync(folder) ? readdirSync(folder).toSorted() : [];
  const lines = names.flatMap((name) => {
    const { title, rows, notes } = JSON.parse(readFileSync(`${folder}/${name}`, "utf8")) as Figures;
    const written = rows.map(
      ({ what, measured, aim }) => `${what.padEnd(64)} ${measured.padStart(10)}   ${(aim ?? "").padStart(8)}`,
    );
    return [
      "",
      `${title.padEnd(64)} ${"measured".padStart(10)}   ${"aim".padStart(8)}`,
      ...written.map((line) => line.trimEnd()),
      ...notes.map((note) => `  ${note}`),
    ];
  });
  // Other work at the same time has lengthened every figure.
  lines.push(
    "",
    `load of ${availableParallelism()} processors: ${before.toFixed(1)} before, ${(loadavg()[0] ?? 0).toFixed(1)} after`,
  );
  process.stdout.write(`${lines.join("\n")}\n`);
}
