/**
 * Starts Pyodide with the packages of the site, fresh or from a memory that was kept (`memory`).
 *
 * A memory holds addresses of functions, so these must come to the same places at each start: the compiled library is loaded
 * before Python begins, and a memory is neither taken nor used where the table of functions has another length.
 *
 * What Pyodide does not document is used here: `_makeSnapshot`, `_loadSnapshot`, and Emscripten's module. Its version is pinned.
 */
import type { loadPyodide as Load, PyodideConfig, PyodideInterface } from "pyodide";

import type { Parts } from "../api/site-parts";
import { filesOf } from "./archive";
import type { Fetching } from "./fetching";
import { giveBack, type Memory } from "./memory";

type Bytes = Uint8Array<ArrayBuffer>;

/** What is used of Emscripten's module. */
interface Module {
  preRun: ((module: Module) => void)[];
  addRunDependency: (what: string) => void;
  removeRunDependency: (what: string) => void;
  FS: {
    mkdirTree: (path: string) => void;
    writeFile: (path: string, bytes: Bytes, options: { canOwn: boolean }) => void;
  };
  newDSO: (name: string, handle: undefined, exports: unknown) => { global: boolean; exports: unknown };
  loadWebAssemblyModule: (made: WebAssembly.Module, flags: object, name: string, local: object) => Promise<unknown>;
  wasmTable: { length: number };
  _emscripten_resize_heap: (bytes: number) => unknown;
}

type Create = (settings: Module) => Promise<Module>;

interface Config {
  indexURL: string;
  env: Record<string, string>;
  createPyodideModule: Create;
  _makeSnapshot?: boolean;
  _loadSnapshot?: Bytes;
}

interface Hidden {
  _module: Module;
  _api: { config: { _loadSnapshot?: Bytes } };
  makeMemorySnapshot: () => Bytes;
}

export interface Started {
  pyodide: PyodideInterface;
  /** The memory, where it can be used again. */
  memory: Memory | null;
}

/** In `memory`, `modules` were imported; they are, if it is null. */
export async function startPython(
  base: string,
  { pyodide: place, place: into, libraries, packages }: Parts,
  fetching: Pick<Fetching, "bytes" | "module">,
  env: Record<string, string>,
  modules: string,
  memory: Memory | null,
): Promise<Started> {
  const indexURL = base + place;
  const [{ loadPyodide }, { default: create }] = (await Promise.all([
    import(/* @vite-ignore */ `${indexURL}pyodide.mjs`),
    import(/* @vite-ignore */ `${indexURL}pyodide.asm.mjs`),
  ])) as [{ loadPyodide: typeof Load }, { default: Create }];
  let table = 0;
  let fail: (cause: unknown) => void = () => undefined;
  const failed = new Promise<never>((_, reject) => {
    fail = reject;
  });
  failed.catch(() => undefined);
  const prepare = async (module: Module) => {
    for (const [name, file] of Object.entries(libraries)) {
      await library(module, `${into}/${name}`, await fetching.module(file));
    }
    table = module.wasmTable.length;
    if (memory === null) return;
    if (table !== memory.table) throw new Error("the memory belongs to other functions");
    module._emscripten_resize_heap(memory.bytes.length);
  };
  const config: Config = {
    indexURL,
    env,
    createPyodideModule: (settings) => {
      settings.preRun.push((module) => {
        module.addRunDependency("packages");
        prepare(module).then(() => module.removeRunDependency("packages"), fail);
      });
      return create(settings);
    },
    ...(memory === null ? { _makeSnapshot: true } : { _loadSnapshot: memory.bytes }),
  };
  const pyodide = await Promise.race([loadPyodide(config as unknown as PyodideConfig), failed]);
  // Not earlier: Pyodide makes a list of the packages that are there when it begins, which no memory can hold.
  const { _module } = pyodide as unknown as Hidden;
  write(_module, filesOf(await fetching.bytes(packages)), into);
  // Python looks for them as files, and finds them loaded.
  write(
    _module,
    Object.keys(libraries).map((name) => [name, new Uint8Array()]),
    into,
  );
  if (memory !== null) {
    // It is in use now, and need not be there twice.
    delete (pyodide as unknown as Hidden)._api.config._loadSnapshot;
    giveBack(memory.bytes);
    return { pyodide, memory: null };
  }
  pyodide.runPython(`import ${modules}`);
  return { pyodide, memory: memoryOf(pyodide as unknown as Hidden, table) };
}

/** The memory as it is, or null if it could not be used again. */
function memoryOf(pyodide: Hidden, table: number): Memory | null {
  try {
    return pyodide._module.wasmTable.length === table ? { bytes: pyodide.makeMemorySnapshot(), table } : null;
  } catch (cause) {
    console.warn("modules are read again at the next visit:", cause);
    return null;
  }
}

function write({ FS }: Module, files: Iterable<[name: string, bytes: Bytes]>, into: string): void {
  const folders = new Set<string>();
  for (const [name, bytes] of files) {
    const path = `${into}/${name}`;
    const folder = path.slice(0, path.lastIndexOf("/"));
    if (!folders.has(folder)) FS.mkdirTree(folder);
    folders.add(folder);
    FS.writeFile(path, bytes, { canOwn: true });
  }
}

/** Loads a compiled library under the name by which Python will ask for it. */
async function library(module: Module, path: string, compiled: WebAssembly.Module): Promise<void> {
  const flags = { loadAsync: true, global: false, nodelete: true };
  const made = module.newDSO(path, undefined, "loading");
  made.global = false;
  made.exports = await module.loadWebAssemblyModule(compiled, flags, path, {});
}
