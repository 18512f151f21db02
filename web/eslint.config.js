import js from "@eslint/js";
import { defineConfig, globalIgnores } from "eslint/config";
import reactHooks from "eslint-plugin-react-hooks";
import globals from "globals";
import tseslint from "typescript-eslint";

import { moduleState, ownStore } from "./build/store-rule.js";
import { spokenWords } from "./build/words-rule.js";

export default defineConfig([
  globalIgnores(["dist", "coverage"]),
  {
    files: ["**/*.{ts,tsx}"],
    extends: [js.configs.recommended, tseslint.configs.recommendedTypeChecked, reactHooks.configs.flat.recommended],
    languageOptions: {
      globals: globals.browser,
      parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname },
    },
    rules: {
      eqeqeq: ["error", "always", { null: "ignore" }],
      "@typescript-eslint/consistent-type-imports": "error",
      "@typescript-eslint/no-unused-vars": ["error", { argsIgnorePattern: "^_", varsIgnorePattern: "^_" }],
      "@typescript-eslint/restrict-template-expressions": ["error", { allowNumber: true }],
      "@typescript-eslint/switch-exhaustiveness-check": ["error", { considerDefaultExhaustiveForUnions: true }],
    },
  },
  {
    // People type numbers with the digits of their keyboard: `readNumber` (i18n/numbers.ts) reads them, in the same way in
    // every field. What is left out reads what programs wrote: settings, XML, pictures, attributes of its own.
    files: ["src/**/*.{ts,tsx}"],
    ignores: [
      "src/i18n/{numbers,words}.ts",
      "src/{model,site,testing}/**",
      "src/components/scene/**",
      "src/features/export/**",
      "src/features/arena/stage/**",
      "src/features/canvas/{active.ts,Badges.tsx,Lines.tsx}",
      "src/features/robots/board-run.ts",
      "src/features/run/speed.ts",
      "src/ui/folding.ts",
      "src/**/*.test.{ts,tsx}",
    ],
    rules: {
      "no-restricted-syntax": [
        "error",
        ...[
          "CallExpression[callee.name=/^(Number|parseInt|parseFloat)$/]",
          "CallExpression[callee.object.name='Number'][callee.property.name=/^parse/]",
          "UnaryExpression[operator='+'][argument.type!='Literal']",
          "JSXAttribute[name.name='type'][value.value='number']",
        ].map((selector) => ({
          selector,
          message: "Read a typed number with readNumber (i18n/numbers.ts), in a NumberInput.",
        })),
      ],
    },
  },
  {
    files: ["src/**/*.{ts,tsx}"],
    // Tests put stores into the state that they begin with.
    ignores: ["src/**/*.test.{ts,tsx}", "src/testing/**"],
    plugins: {
      kitrobot: { rules: { "own-store": ownStore, "module-state": moduleState, "spoken-words": spokenWords } },
    },
    rules: { "kitrobot/own-store": "error", "kitrobot/module-state": "error", "kitrobot/spoken-words": "error" },
  },
  {
    // No state of the page: what is fetched or made once, the line to the server, what a browser gives one of, and the press
    // or the frame that was before. `session/poses.ts` is written sixty times a second.
    files: [
      "src/{api,site,theme}/**",
      "src/app/App.tsx",
      "src/components/{fields/sound,graph/ink,picture-clock}.ts",
      "src/i18n/words.ts",
      "src/session/{features,poses}.ts",
      "src/ui/{pointer-drag,second-click}.ts",
    ],
    rules: { "kitrobot/module-state": "off" },
  },
  {
    // The model is the page's meaning: it runs and is tested without React.
    // studio.ts is its door to the page: the store that components subscribe to.
    files: ["src/model/**/*.ts"],
    ignores: ["src/model/studio.ts", "src/model/**/*.test.ts"],
    rules: {
      "no-restricted-imports": ["error", { patterns: ["react", "react-dom", "zustand", "**/*.tsx"] }],
    },
  },
  {
    files: ["eslint.config.js", "build/*.js"],
    extends: [js.configs.recommended],
    languageOptions: { globals: globals.node },
  },
]);
