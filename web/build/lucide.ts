/**
 * Sets of Lucide's icons as data: `import("./some.lucide")` gives the shapes of each icon that the file names, `*` for all.
 *
 * Shapes alone, without a component for each icon: they are half as large.
 */
import { readdir, readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";
import type { Plugin } from "vite";

type Shape = [tag: string, attributes: Record<string, string>];

const FOLDER = new URL("../node_modules/lucide-react/dist/esm/icons/", import.meta.url);
const ENDING = ".mjs";

export function lucide(): Plugin {
  return {
    name: "lucide",
    async transform(code, id) {
      if (!id.endsWith(".lucide")) return null;
      const words = code.replaceAll(/^#.*$/gm, "").split(/\s+/).filter(Boolean);
      const names = words[0] === "*" ? await everyName() : words;
      const shapes = await Promise.all(names.map(async (name) => [name, await shapesOf(name)] as const));
      return { code: `export default ${JSON.stringify(Object.fromEntries(shapes))};`, map: null };
    },
  };
}

async function everyName(): Promise<string[]> {
  const files = await readdir(FOLDER);
  return files.filter((file) => file.endsWith(ENDING)).map((file) => file.slice(0, -ENDING.length));
}

async function shapesOf(name: string): Promise<Shape[]> {
  const file = new URL(name + ENDING, FOLDER);
  // An icon that was renamed is one line, which names the other.
  const other = /from '\.\/([\w-]+)\.mjs'/.exec(await readFile(file, "utf8"))?.[1];
  if (other !== undefined) return shapesOf(other);
  const module = (await import(pathToFileURL(file.pathname).href)) as { __iconData: { node: Shape[] } };
  return module.__iconData.node.map(([tag, { key: _, ...attributes }]) => [tag, attributes]);
}
