// The tests in a browser, two files at a time. A file that fails is run once more, alone: what only a busy computer breaks passes then, and is
// named at the end all the same.
import { spawnSync } from "node:child_process";
import { readFileSync, rmSync } from "node:fs";
import { relative } from "node:path";
import { fileURLToPath } from "node:url";

const FOLDER = fileURLToPath(new URL(".", import.meta.url));
const RESULTS = fileURLToPath(new URL("../../target/e2e/browser.json", import.meta.url));

/** Runs files; the exit status, and the files in which something failed. */
function run(...args) {
  rmSync(RESULTS, { force: true });
  const { status } = spawnSync(
    process.execPath,
    ["node_modules/vitest/vitest.mjs", "run", "--config", "vitest.config.ts", ...args]
      .concat("--reporter=verbose", "--reporter=json", `--outputFile.json=${RESULTS}`),
    { cwd: FOLDER, stdio: "inherit" },
  );
  if (status === 0) return { status, failed: [] };
  try {
    const { testResults } = JSON.parse(readFileSync(RESULTS, "utf8"));
    const failed = testResults.filter((file) => file.status !== "passed").map((file) => relative(FOLDER, file.name));
    return { status, failed };
  } catch {
    return { status: status ?? 1, failed: [] };
  }
}

const first = run("browser", "--fileParallelism", "--maxWorkers=2");
if (first.status === 0 || first.failed.length === 0) process.exit(first.status);
console.log(`\nOnce more, alone: ${first.failed.join(", ")}`);
const again = run(...first.failed);
if (again.status === 0) console.log(`\nFlaky, passed at the second try: ${first.failed.join(", ")}`);
process.exit(again.status);
