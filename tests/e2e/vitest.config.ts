import { defineConfig } from "vitest/config";

// One file after the other, because what is installed needs the screen for itself; `npm run browser` has two browsers at a time.
export default defineConfig({
  test: {
    include: ["{browser,installed,screenshots}/**/*.test.ts"],
    setupFiles: ["support/each.ts"],
    fileParallelism: false,
    testTimeout: 120_000,
    hookTimeout: 120_000,
    reporters: ["verbose"],
  },
});
