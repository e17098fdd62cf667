import { fileURLToPath } from "node:url";

/** The root of the repository, with a slash at its end. */
export const root = fileURLToPath(new URL("../../../", import.meta.url));

/** Where screenshots of a run go, to be looked at. */
export const pictures = `${root}target/e2e/pictures`;
