/**
 * A mission inside a link: `#mission=…&name=…`, the text of the `.krt` compressed (deflate) in the letters of an address.
 *
 * What stands in a link may come from anybody: it is as long as it may be, unpacks to as much as it may, or is refused; what
 * is in it is then read as any file is.
 */
import { joinBytes } from "../model/bytes";

export const MOST_LETTERS = 1_000_000;
/** Of the text, unpacked: a mission of some ten thousand parts, which Python in the page reads and checks in seconds. */
export const MOST_BYTES = 2 * 1024 * 1024;
const MOST_NAME = 80;

export type LinkFault = "site.link-long" | "site.link-damaged";

export class LinkError extends Error {
  readonly fault: LinkFault;

  constructor(fault: LinkFault) {
    super(fault);
    this.fault = fault;
  }
}

export interface LinkedMission {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
}

type Bytes = Uint8Array<ArrayBuffer>;

/** The part of an address behind its `#`. */
export async function linkTo(text: string, name: string): Promise<string> {
  const bytes = new TextEncoder().encode(text);
  if (bytes.length > MOST_BYTES) throw new LinkError("site.link-long");
  const packed = await through(bytes, new CompressionStream("deflate-raw"), Infinity);
  const said = toLetters(packed);
  if (said.length > MOST_LETTERS) throw new LinkError("site.link-long");
  return `mission=${said}&name=${encodeURIComponent(name)}`;
}

/** Whether the part of an address behind its `#` holds a mission. */
export function holdsMission(hash: string): boolean {
  return hash.replace(/^#/, "").startsWith("mission=");
}

/** The mission of a link. */
export async function missionOf(hash: string): Promise<LinkedMission> {
  const said = hash.replace(/^#/, "");
  if (said.length > MOST_LETTERS + 1000) throw new LinkError("site.link-long");
  const found = new URLSearchParams(said);
  const name = (found.get("name") ?? "").replace(/[^\p{L}\p{N} ._-]/gu, "").slice(0, MOST_NAME);
  const bytes = await through(
    fromLetters(found.get("mission") ?? ""),
    new DecompressionStream("deflate-raw"),
    MOST_BYTES,
  );
  return { name: /\.krt$/i.test(name) ? name : `${name || "mission"}.krt`, bytes };
}

/** All that comes out of a stream of (de)compression, at most so much. */
async function through(bytes: Bytes, stream: CompressionStream | DecompressionStream, most: number): Promise<Bytes> {
  const pieces: Uint8Array[] = [];
  let size = 0;
  const writer = stream.writable.getWriter();
  // What is wrong with it is told at the other end.
  const written = writer.write(bytes).then(() => writer.close());
  written.catch(() => undefined);
  const reader = stream.readable.getReader();
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      size += value.length;
      if (size > most) throw new LinkError("site.link-long");
      pieces.push(value);
    }
    await written;
  } catch (cause) {
    void reader.cancel().catch(() => undefined);
    throw cause instanceof LinkError ? cause : new LinkError("site.link-damaged");
  }
  return joinBytes(pieces);
}

const PORTION = 0x8000;

function toLetters(bytes: Uint8Array): string {
  let raw = "";
  for (let at = 0; at < bytes.length; at += PORTION) raw += String.fromCharCode(...bytes.subarray(at, at + PORTION));
  return btoa(raw).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function fromLetters(letters: string): Bytes {
  if (!/^[\w-]+$/.test(letters)) throw new LinkError("site.link-damaged");
  try {
    return Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
  } catch {
    throw new LinkError("site.link-damaged");
  }
}
