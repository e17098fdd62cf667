/** Things that everybody has in mind, by their longest side in mm. */
const THINGS: readonly (readonly [number, string])[] = [
  [24, "about as large as a coin"],
  [55, "about as long as a match"],
  [75, "about as long as a little finger"],
  [100, "about as long as a playing card"],
  [190, "about as long as a pencil"],
  [240, "about as long as a sheet of paper is wide"],
  [330, "about as large as a bottle"],
  [550, "about as long as an arm"],
  [1100, "about as long as a guitar"],
  [2100, "about as large as a door"],
  [6000, "about as long as a car"],
];

/** What something of this longest side, in mm, is about as large as; null beyond what helps. */
export function likeness(mm: number): string | null {
  if (!(mm > 0)) return null;
  if (mm < 3) return "smaller than a pea: check the unit";
  const [, thing] = THINGS.find(([most]) => mm <= most) ?? [];
  return thing ?? "larger than a car: check the unit";
}
