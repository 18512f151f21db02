/**
 * The sentences of Python in other languages than English: those of a language are fetched before the first answer in it.
 *
 * Where they cannot be fetched, Python says it in English, and the next request tries again.
 */
type Bytes = Uint8Array<ArrayBuffer>;

export class Words {
  readonly #base: string;
  readonly #files: Readonly<Record<string, string>>;
  readonly #write: (name: string, bytes: Bytes) => void;
  readonly #there = new Map<string, Promise<void>>();

  /** `files`: by language, the file that Python reads; `write` puts it there. */
  constructor(base: string, files: Readonly<Record<string, string>>, write: (name: string, bytes: Bytes) => void) {
    this.#base = base;
    this.#files = files;
    this.#write = write;
  }

  /** Resolves when Python has what it can have of a language. */
  async have(language: string): Promise<void> {
    const name = Object.hasOwn(this.#files, language) ? this.#files[language] : undefined;
    if (name === undefined) return;
    const coming = this.#there.get(language) ?? this.#fetch(name, language);
    this.#there.set(language, coming);
    await coming.catch((cause: unknown) => {
      console.warn(`in English, as ${name} cannot be fetched:`, cause);
      this.#there.delete(language);
    });
  }

  async #fetch(name: string, language: string): Promise<void> {
    const answer = await fetch(new URL(`words/${language}.po.zlib`, this.#base));
    if (!answer.ok || answer.body === null) throw new Error(String(answer.status));
    const unpacked = new Response(answer.body.pipeThrough(new DecompressionStream("deflate")));
    this.#write(name, new Uint8Array(await unpacked.arrayBuffer()));
  }
}
