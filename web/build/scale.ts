/**
 * Puts the sizes, distances and layers of `theme/tokens.css` in place of their names in the built styles.
 *
 * No theme changes them, and every first load would carry their names some thousand times.
 */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";

const TOKENS = fileURLToPath(new URL("../src/theme/tokens.css", import.meta.url));
const WRITTEN = /^ *(--(?:type|leading|space|layer)-[\w-]+): ([^;]+);\n/gm;
const READ = /var\((--(?:type|leading|space|layer)-[\w-]+)\)/g;

export function putScale(): Plugin {
  const values = new Map([...readFileSync(TOKENS, "utf8").matchAll(WRITTEN)].map(([, name, value]) => [name, value]));
  return {
    name: "put-scale",
    apply: "build",
    enforce: "pre",
    transform(code, id) {
      if (!id.endsWith(".css")) return null;
      return code.replace(WRITTEN, "").replace(READ, (_, name: string) => {
        const value = values.get(name);
        if (value === undefined) throw new Error(`${id} reads ${name}, which theme/tokens.css does not write`);
        return value;
      });
    },
  };
}
