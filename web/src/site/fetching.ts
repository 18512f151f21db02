/** Fetches the files of Python, says how much of them came, and unpacks them. */

/** What `site.json` says. */
export interface Parts {
  /** Changes with every byte of the files below. */
  version: string;
  pyodide: string;
  packages: string;
  /** Where packages belong in Pyodide. */
  place: string;
  /** Files that Python needs, with their sizes as they travel. */
  files: Record<string, number>;
}

type Bytes = Uint8Array<ArrayBuffer>;

/** The ending of packed files. */
const PACKED = ".packed";

const scope = self as unknown as { fetch: typeof fetch };
const network = scope.fetch.bind(self);

export class UnfetchedError extends Error {}

export async function partsOf(base: string): Promise<Parts> {
  const said = await network(new URL("site.json", base)).catch(() => null);
  if (!said?.ok) throw new UnfetchedError("site.json");
  return (await said.json()) as Parts;
}

export class Fetching {
  readonly #base: string;
  readonly #files: Record<string, number>;
  readonly #total: number;
  readonly #tell: (fetched: number, total: number) => void;
  #fetched = 0;
  #told = 0;
  /** What did not come; whoever asked for it may have kept that to himself. */
  missing: UnfetchedError | null = null;

  constructor(base: string, files: Record<string, number>, tell: (fetched: number, total: number) => void) {
    this.#base = base;
    this.#files = files;
    this.#total = Object.values(files).reduce((sum, one) => sum + one, 0);
    this.#tell = tell;
  }

  /** From now on Pyodide, which fetches its own files by their names, gets them unpacked. */
  answerFetch(): void {
    scope.fetch = async (asked, options) => {
      const address = asked instanceof Request ? asked.url : String(asked);
      const name = address.startsWith(this.#base) ? address.slice(this.#base.length) : "";
      if (!this.#has(name + PACKED)) return network(asked, options);
      const type = name.endsWith(".wasm") ? "application/wasm" : "application/octet-stream";
      return new Response(await this.#get(name), { headers: { "Content-Type": type } });
    };
  }

  /** All bytes of a file, unpacked. */
  async bytes(name: string): Promise<Bytes> {
    return new Uint8Array(await new Response(await this.#get(name)).arrayBuffer());
  }

  #has(name: string): boolean {
    return Object.hasOwn(this.#files, name);
  }

  async #get(name: string): Promise<ReadableStream<Bytes>> {
    const packed = this.#has(name + PACKED) ? name + PACKED : name;
    const response = await network(new URL(packed, this.#base)).catch(() => null);
    if (!response?.ok || response.body === null) {
      this.missing = new UnfetchedError(packed);
      throw this.missing;
    }
    const counted = response.body.pipeThrough(
      new TransformStream<Bytes, Bytes>({
        transform: (chunk, out) => {
          this.#count(chunk.length);
          out.enqueue(chunk);
        },
      }),
    );
    return packed === name ? counted : counted.pipeThrough(new DecompressionStream("gzip"));
  }

  #count(bytes: number): void {
    this.#fetched = Math.min(this.#fetched + bytes, this.#total);
    if (this.#fetched < this.#told + this.#total / 100 && this.#fetched < this.#total) return;
    this.#told = this.#fetched;
    this.#tell(this.#fetched, this.#total);
  }
}
