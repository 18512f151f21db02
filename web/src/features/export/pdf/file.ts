/**
 * A PDF file, written object by object: numbers, streams, the table of places at the end.
 *
 * Nothing that the clock or chance decides is in it: the same drawing gives the same bytes. Left to others: what the
 * objects mean.
 */
import { joinBytes } from "../../../model/bytes";

/** How one object speaks of another: "7 0 R". */
export type Ref = `${number} 0 R`;

const encoder = new TextEncoder();

async function through(stream: CompressionStream | DecompressionStream, bytes: Uint8Array<ArrayBuffer>) {
  const writer = stream.writable.getWriter();
  // A failure here is reported by the reading side too.
  const written = Promise.all([writer.write(bytes), writer.close()]).catch(() => undefined);
  const whole = new Uint8Array(await new Response(stream.readable).arrayBuffer());
  await written;
  return whole;
}

/** Bytes in the form of zlib, which PDF calls FlateDecode. */
export function deflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  return through(new CompressionStream("deflate"), bytes);
}

export function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  return through(new DecompressionStream("deflate"), bytes);
}

function hex(code: number): string {
  return code.toString(16).padStart(4, "0");
}

/** Any text as a string of PDF, in UTF-16. */
export function words(text: string): string {
  return `<feff${utf16(text)}>`;
}

/** The UTF-16 code units of a text as hexadecimal digits. */
export function utf16(text: string): string {
  return Array.from({ length: text.length }, (_, at) => hex(text.charCodeAt(at))).join("");
}

/** A number as PDF takes it: no exponent, at most three digits behind the point. */
export function num(value: number): string {
  const text = value.toFixed(3).replace(/\.?0+$/, "");
  return text === "-0" || text === "" ? "0" : text;
}

export class PdfFile {
  readonly #objects: Uint8Array[] = [];

  /** A number for an object that is written later, because others speak of it before. */
  reserve(): Ref {
    this.#objects.push(new Uint8Array());
    return `${this.#objects.length} 0 R`;
  }

  /** Writes a reserved object. */
  put(ref: Ref, body: string): Ref {
    this.#objects[parseInt(ref) - 1] = encoder.encode(body);
    return ref;
  }

  add(body: string): Ref {
    return this.put(this.reserve(), body);
  }

  /** A stream, packed; `entries` are those of its dictionary besides length and packing. */
  async stream(entries: string, bytes: Uint8Array<ArrayBuffer>): Promise<Ref> {
    const ref = this.reserve();
    const packed = await deflate(bytes);
    const head = encoder.encode(`<< ${entries} /Filter /FlateDecode /Length ${String(packed.length)} >>\nstream\n`);
    const tail = encoder.encode("\nendstream");
    const body = new Uint8Array(head.length + packed.length + tail.length);
    body.set(head);
    body.set(packed, head.length);
    body.set(tail, head.length + packed.length);
    this.#objects[parseInt(ref) - 1] = body;
    return ref;
  }

  /** The whole file. */
  finish(root: Ref, info: Ref): Uint8Array<ArrayBuffer> {
    // The second line marks the file as binary for transfer programs.
    const parts: Uint8Array[] = [encoder.encode("%PDF-1.7\n%"), new Uint8Array([0xe2, 0xe3, 0xcf, 0xd3, 10])];
    let at = parts.reduce((sum, part) => sum + part.length, 0);
    const places: string[] = [];
    const push = (part: Uint8Array) => {
      parts.push(part);
      at += part.length;
    };
    for (const [index, body] of this.#objects.entries()) {
      places.push(`${String(at).padStart(10, "0")} 00000 n \n`);
      push(encoder.encode(`${String(index + 1)} 0 obj\n`));
      push(body);
      push(encoder.encode("\nendobj\n"));
    }
    const count = String(this.#objects.length + 1);
    const table = `xref\n0 ${count}\n0000000000 65535 f \n${places.join("")}`;
    push(
      encoder.encode(
        `${table}trailer\n<< /Size ${count} /Root ${root} /Info ${info} >>\nstartxref\n${String(at)}\n%%EOF\n`,
      ),
    );
    return joinBytes(parts);
  }
}
