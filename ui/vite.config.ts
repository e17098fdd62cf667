import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";

// WebKitGTK 2.40 is the oldest engine that shows this window.
export default defineConfig({
  plugins: [react()],
  clearScreen: false,
  build: { target: "safari16", chunkSizeWarningLimit: 1500 },
  // The thread that reads PDF files is a module.
  worker: { format: "es" },
  // Two at a time on two cores, where one is what it chooses itself. Each file has a world of its own in the same process: making a
  // process and its DOM for each takes twice as long as the tests.
  test: { include: ["{src,tests}/**/*.test.{ts,tsx,mjs}"], maxWorkers: 2, pool: "vmThreads" },
});
