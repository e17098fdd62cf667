/** The settings of a machine's driver: as they are, where they come from, and what of them a profile has to set. */

import type { SettingValue } from "../../../generated/responses";

export type Values = Readonly<Record<string, unknown>>;

/** Dotted keys become objects in objects. */
export function valuesOf(settings: readonly SettingValue[]): Values {
  const all: Record<string, unknown> = {};
  // Shorter keys first: a default for a whole object does not hide what is set within.
  for (const { key, value } of settings.toSorted((a, b) => a.key.length - b.key.length)) {
    const path = key.split(".");
    const last = path.pop() ?? key;
    let at = all;
    for (const part of path) {
      const next = at[part];
      const inner: Record<string, unknown> =
        typeof next === "object" && next !== null && !Array.isArray(next) ? { ...next } : {};
      at[part] = inner;
      at = inner;
    }
    at[last] = value;
  }
  return all;
}

/** What sets the field of a key: itself, or something within it. */
export function sourceOf(settings: readonly SettingValue[], key: string): SettingValue | null {
  const within = settings.filter((setting) => setting.key === key || setting.key.startsWith(`${key}.`));
  return within.find(({ set_by }) => set_by !== null) ?? within[0] ?? null;
}

/** "set by my-kit, line 12", "driver's default". */
export function sourcePhrase(source: SettingValue | null, machine: string): string {
  if (!source || source.set_by === null) return "driver's default";
  const line = source.line === null ? "" : `, line ${source.line}`;
  return source.set_by === machine ? `set here${line}` : `set by ${source.set_by}${line}`;
}

/** The fields that a machine's own profile sets. */
export function ownKeys(settings: readonly SettingValue[], machine: string): ReadonlySet<string> {
  return new Set(settings.filter(({ set_by }) => set_by === machine).map(({ key }) => key.split(".")[0] ?? key));
}

/** The same as JSON, whatever the order of keys. What is not there is the same as what is not set. */
export function sameValue(a: unknown, b: unknown): boolean {
  const [one, other] = [a ?? null, b ?? null];
  if (typeof one !== "object" || typeof other !== "object" || one === null || other === null) return one === other;
  if (Array.isArray(one) !== Array.isArray(other)) return false;
  const keys = new Set([...Object.keys(one), ...Object.keys(other)]);
  return [...keys].every((key) => sameValue((one as Values)[key], (other as Values)[key]));
}

/** The fields that a person has changed. */
export function changedKeys(before: Values, after: Values): readonly string[] {
  const keys = new Set([...Object.keys(before), ...Object.keys(after)]);
  return [...keys].filter((key) => !sameValue(before[key], after[key])).toSorted();
}

/** What the profile has to set: what it sets already, and what was changed; without what is to come from its parent again. */
export function toWrite(before: Values, after: Values, own: ReadonlySet<string>, back: string | null = null): Values {
  const changed = new Set(changedKeys(before, after));
  return Object.fromEntries(
    Object.entries(after).filter(
      ([key, value]) => key !== back && value !== undefined && (own.has(key) || changed.has(key)),
    ),
  );
}
