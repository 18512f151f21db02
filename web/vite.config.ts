import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";

import { catalogues } from "./build/catalogues.ts";
import { smallFonts } from "./build/fonts.ts";
import { lucide } from "./build/lucide.ts";
import { packFiles } from "./build/pack.ts";
import { putScale } from "./build/scale.ts";

/** Where `npm run dev` finds the Python server; the built page is served by that server itself. */
const SERVER = process.env["KITROBOT_SERVER"] ?? "http://127.0.0.1:8765";

export default defineConfig({
  // Relative addresses: the page works under any path that a server gives it.
  base: "./",
  plugins: [react(), catalogues(), lucide(), smallFonts(), putScale(), packFiles()],
  worker: { format: "es" },
  build: {
    target: "es2022",
    // The page travels inside a Python wheel: fonts and icons stay files, nothing is inlined as base64.
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1500,
    // What the first load needs is one chunk, also where a later one shares parts of it: it compresses better than eight.
    rolldownOptions: {
      output: { codeSplitting: { groups: [{ name: "page", tags: ["$initial"] }] } },
    },
    // The licences of everything that the page carries travel with it.
    license: { fileName: "licenses.md" },
  },
  server: {
    proxy: {
      "/api": { target: SERVER, changeOrigin: true, ws: true },
    },
  },
  test: {
    environment: "jsdom",
    include: ["src/**/*.test.{ts,tsx}", "test/**/*.test.{ts,tsx}"],
    setupFiles: ["src/testing/english.ts"],
    alias: [{ find: /^zustand$/, replacement: `${import.meta.dirname}/src/testing/zustand.ts` }],
    passWithNoTests: false,
    // It ends only what hangs: thousands of random edits take a second alone, and a minute where the machine has much else to do.
    testTimeout: 300_000,
    // Not intervals: jsdom draws its frames by one, and would draw no more when it began it in a test's own time.
    fakeTimers: {
      toFake: [
        ...(["Date", "performance", "setTimeout", "clearTimeout", "setImmediate", "clearImmediate"] as const),
        ...(["requestAnimationFrame", "cancelAnimationFrame", "requestIdleCallback", "cancelIdleCallback"] as const),
      ],
    },
    maxWorkers: 2,
    // One jsdom for each worker: making one takes longer than most files of tests.
    isolate: false,
    // What tests read as text; other styles are left out.
    css: { include: [/theme\/tokens/, /\?raw$/] },
  },
});
