import { defineConfig } from "vitest/config";

// One file after the other: the machine has two cores, and a browser takes both.
export default defineConfig({
  test: {
    include: ["{browser,installed,screenshots}/**/*.test.ts"],
    fileParallelism: false,
    testTimeout: 120_000,
    hookTimeout: 120_000,
    reporters: ["verbose"],
  },
});
