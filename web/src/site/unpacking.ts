/** What is said between the worker with Python in it and the worker that fetches and unpacks its files. */
import { XzReadableStream } from "xz-decompress";

import { joinBytes } from "../model/bytes";

type Bytes = Uint8Array<ArrayBuffer>;

/** A packed file of so many bytes; `module`: it is WebAssembly, and wanted compiled. */
export interface Wanted {
  name: string;
  address: string;
  size: number;
  module: boolean;
}

/** `counted`: so many bytes came from the network. */
export type FromUnpacker =
  | { kind: "counted"; bytes: number }
  | { kind: "bytes"; name: string; bytes: Bytes }
  | { kind: "module"; name: string; module: WebAssembly.Module }
  | { kind: "unfetched"; name: string }
  | { kind: "damaged"; name: string; reason: string };

/** All bytes of a packed file (xz). Rejects where it is damaged or cut off: it holds a sum of itself. */
export async function unpacked(packed: ReadableStream<Bytes>): Promise<Bytes> {
  const reader = new XzReadableStream(packed).getReader();
  const pieces: Uint8Array[] = [];
  for (let next = await reader.read(); !next.done; next = await reader.read()) pieces.push(next.value);
  return joinBytes(pieces);
}
