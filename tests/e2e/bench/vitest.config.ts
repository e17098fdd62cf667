import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

// Figures, not tests: they fail where something does not work, never because it takes long.
export default defineConfig({
  root: fileURLToPath(new URL(".", import.meta.url)),
  cacheDir: "../node_modules/.vite",
  test: {
    include: ["*.bench.ts"],
    globalSetup: ["table.ts"],
    env: { E2E_BUILD: "release" },
    fileParallelism: false,
    testTimeout: 600_000,
    hookTimeout: 120_000,
    reporters: ["dot"],
  },
});
