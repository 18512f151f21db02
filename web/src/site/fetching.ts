/** The files of Python, which another worker fetches and unpacks (`unpacker`); says how much of them came. */
import type { Parts } from "../api/site-parts";
import type { FromUnpacker, Wanted } from "./unpacking";

type Bytes = Uint8Array<ArrayBuffer>;

/** The ending of packed files. */
const PACKED = ".packed";

const scope = self as unknown as { fetch: typeof fetch };
const network = scope.fetch.bind(self);

export class UnfetchedError extends Error {}

interface Waiting {
  made: Promise<Bytes | WebAssembly.Module>;
  resolve: (made: Bytes | WebAssembly.Module) => void;
  reject: (cause: unknown) => void;
}

function waiting(): Waiting {
  let [resolve, reject]: [Waiting["resolve"], Waiting["reject"]] = [() => undefined, () => undefined];
  const made = new Promise<Bytes | WebAssembly.Module>((yes, no) => {
    [resolve, reject] = [yes, no];
  });
  // Whoever waits for another file first hears of it too.
  made.catch(() => undefined);
  return { made, resolve, reject };
}

export class Fetching {
  readonly #base: string;
  readonly #runtime: string;
  readonly #total: number;
  readonly #tell: (fetched: number, total: number) => void;
  readonly #files: Map<string, Waiting>;
  #fetched = 0;
  #told = 0;
  /** What did not come; whoever asked for it may have kept that to himself. */
  missing: UnfetchedError | null = null;

  /** Begins to fetch; `unpacker`: the line to that worker. */
  constructor(base: string, parts: Parts, unpacker: MessagePort, tell: (fetched: number, total: number) => void) {
    this.#base = base;
    this.#runtime = `${parts.pyodide}pyodide.asm.wasm`;
    this.#tell = tell;
    const libraries = Object.values(parts.libraries);
    // What Python begins with comes first.
    const first = [this.#runtime, ...libraries];
    const last = Object.keys(parts.files)
      .filter((name) => name.endsWith(PACKED))
      .map((name) => name.slice(0, -PACKED.length))
      .filter((name) => !first.includes(name) && name !== parts.packages);
    const names = [...first, ...last, parts.packages];
    this.#files = new Map(names.map((name) => [name, waiting()]));
    this.#total = names.reduce((sum, name) => sum + (parts.files[name + PACKED] ?? 0), 0);
    const wanted = names.map<Wanted>((name) => ({
      name,
      address: new URL(name + PACKED, base).href,
      size: parts.files[name + PACKED] ?? 0,
      module: first.includes(name),
    }));
    unpacker.onmessage = ({ data }: MessageEvent<FromUnpacker>) => this.#hear(data);
    unpacker.postMessage(wanted);
    void Promise.allSettled([...this.#files.values()].map(({ made }) => made)).then(() => unpacker.postMessage(null));
  }

  /** From now on Pyodide, which fetches its own files by their names and compiles them, gets what was fetched here. */
  answerPyodide(): void {
    scope.fetch = async (asked, options) => {
      const address = asked instanceof Request ? asked.url : String(asked);
      const name = address.startsWith(this.#base) ? address.slice(this.#base.length) : "";
      if (!this.#files.has(name)) return network(asked, options);
      return new Response(name === this.#runtime ? null : await this.bytes(name));
    };
    WebAssembly.instantiateStreaming = async (_, imports) => {
      const module = await this.module(this.#runtime);
      return { module, instance: await WebAssembly.instantiate(module, imports ?? {}) };
    };
  }

  /** Gives the files back: Python has what it needs of them. */
  end(): void {
    this.#files.clear();
  }

  /** All bytes of a file, unpacked. */
  async bytes(name: string): Promise<Bytes> {
    return (await this.#files.get(name)?.made) as Bytes;
  }

  async module(name: string): Promise<WebAssembly.Module> {
    return (await this.#files.get(name)?.made) as WebAssembly.Module;
  }

  #hear(said: FromUnpacker): void {
    switch (said.kind) {
      case "counted":
        this.#count(said.bytes);
        break;
      case "bytes":
        this.#files.get(said.name)?.resolve(said.bytes);
        break;
      case "module":
        this.#files.get(said.name)?.resolve(said.module);
        break;
      case "unfetched":
        this.missing ??= new UnfetchedError(said.name + PACKED);
        this.#files.get(said.name)?.reject(this.missing);
        break;
      case "damaged":
        this.#files.get(said.name)?.reject(new Error(`${said.name + PACKED}: ${said.reason}`));
        break;
    }
  }

  #count(bytes: number): void {
    this.#fetched = Math.min(this.#fetched + bytes, this.#total);
    if (this.#fetched < this.#told + this.#total / 100 && this.#fetched < this.#total) return;
    this.#told = this.#fetched;
    this.#tell(this.#fetched, this.#total);
  }
}
