/**
 * The Latin letters of the page's fonts without what the page never shows (see tools/fonts.py), in the place of the packages'.
 *
 * Every first load fetches these; the other letters of the packages are fetched where a text has them.
 */
import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";

const FOLDER = fileURLToPath(new URL("../src/theme/fonts/", import.meta.url));
const PACKAGE = /@fontsource-variable[\\/][\w-]+[\\/]wght\.css$/;
const SMALL = /-latin-wght-normal-[\w-]+\.woff2$/;
const LATIN = /\.\/files\/([\w-]+-latin-wght-normal\.woff2)/g;

export function smallFonts(): Plugin {
  return {
    name: "small-fonts",
    enforce: "pre",
    transform(code, id) {
      if (!PACKAGE.test(id)) return null;
      let found = 0;
      const changed = code.replace(LATIN, (_, name: string) => {
        if (!existsSync(FOLDER + name)) throw new Error(`there is no ${name} in src/theme/fonts: run tools/fonts.py`);
        found++;
        return (FOLDER + name).replaceAll("\\", "/");
      });
      if (found !== 1) throw new Error(`expected one file of Latin letters in ${id}, found ${String(found)}`);
      return changed;
    },
    // Fetched beside the script: the first picture has its letters, and is not laid out again for them.
    transformIndexHtml: {
      order: "post",
      handler: (_, { bundle = {} }) =>
        Object.keys(bundle)
          .filter((name) => SMALL.test(name))
          .map((name) => ({
            tag: "link",
            injectTo: "head",
            attrs: { rel: "preload", as: "font", type: "font/woff2", crossorigin: true, href: `./${name}` },
          })),
    },
  };
}
