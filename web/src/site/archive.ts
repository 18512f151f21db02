/** The archive of Python packages (tar, as `kitrobot site` writes it) as files; the bytes are not copied. */
type Bytes = Uint8Array<ArrayBuffer>;

const BLOCK = 512;
/** Places in a header: where they begin and how long they are. */
const NAME = [0, 100] as const;
const SIZE = [124, 12] as const;
const KIND = [156, 1] as const;
const PREFIX = [345, 155] as const;

export function* filesOf(archive: Bytes): Generator<[name: string, bytes: Bytes]> {
  const decoder = new TextDecoder();
  const field = (at: number, [begin, length]: readonly [number, number]) =>
    decoder.decode(archive.subarray(at + begin, at + begin + length)).replace(/\0[^]*$/u, "");
  for (let at = 0; at + BLOCK <= archive.length && archive[at] !== 0;) {
    const size = parseInt(field(at, SIZE), 8);
    const begin = at + BLOCK;
    if (!(size >= 0 && begin + size <= archive.length)) throw new Error("the archive of packages is damaged");
    const prefix = field(at, PREFIX);
    const name = field(at, NAME);
    // Only files are in it.
    if (["0", ""].includes(field(at, KIND))) {
      yield [prefix === "" ? name : `${prefix}/${name}`, archive.subarray(begin, begin + size)];
    }
    at = begin + Math.ceil(size / BLOCK) * BLOCK;
  }
}
