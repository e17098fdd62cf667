/** Ids of profiles: lower-case letters, digits and single inner hyphens. */

export const isSlug = (id: string): boolean => /^[a-z0-9]+(-[a-z0-9]+)*$/.test(id);

/** An id for a name: "Küche Nr. 2" is "kuche-nr-2"; empty where nothing of the name can be in one. */
export function slugOf(name: string): string {
  return name
    .normalize("NFKD")
    .replace(/\p{M}/gu, "")
    .replace(/ß/g, "ss")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-+|-+$/g, "");
}

/** What is wrong with an id for a new profile; null where nothing is. */
export function slugProblem(id: string, taken: readonly string[]): string | null {
  if (id === "") return "Enter an id.";
  if (!isSlug(id)) return "Use lower-case letters, digits and single hyphens between them.";
  return taken.includes(id) ? `There is a profile “${id}” already: choose another id.` : null;
}
