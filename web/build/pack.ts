/** Lays each file of the built page that gets smaller beside itself, compressed: `.br` and `.gz`. */
import { readdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { promisify } from "node:util";
import { brotliCompress, constants, gzip } from "node:zlib";
import type { Plugin } from "vite";

const PACKED = /\.(?:js|css|svg)$/;

async function pack(path: string): Promise<void> {
  const bytes = await readFile(path);
  const params = { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length };
  const twins = {
    br: await promisify(brotliCompress)(bytes, { params }),
    gz: await promisify(gzip)(bytes, { level: 9 }),
  };
  for (const [ending, twin] of Object.entries(twins)) {
    if (twin.length < bytes.length) await writeFile(`${path}.${ending}`, twin);
  }
}

export function packFiles(): Plugin {
  return {
    name: "pack-files",
    apply: "build",
    enforce: "post",
    async writeBundle({ dir }) {
      if (dir === undefined) return;
      const names = await readdir(dir, { recursive: true, encoding: "utf8" });
      await Promise.all(names.filter((name) => PACKED.test(name)).map((name) => pack(join(dir, name))));
    },
  };
}
