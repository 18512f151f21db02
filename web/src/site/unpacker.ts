/**
 * The worker that fetches the packed files of Python, unpacks them and compiles those that are WebAssembly, while the worker with
 * Python in it does something else. It ends when that has them all: the memory that unpacking takes is given back with it.
 *
 * The page begins it, not the other worker: in Firefox a worker's worker got no files once the server was gone.
 */
import { type FromUnpacker, unpacked, type Wanted } from "./unpacking";

type Bytes = Uint8Array<ArrayBuffer>;

/** From the page comes the line to the other worker, from that what it wants; then null. */
self.addEventListener("message", ({ data }: MessageEvent<MessagePort>) => {
  line = data;
  line.onmessage = ({ data: wanted }: MessageEvent<Wanted[] | null>) => {
    if (wanted === null) self.close();
    else begin(wanted);
  };
});

let line: MessagePort | null = null;

function tell(message: FromUnpacker, transfer: Transferable[] = []): void {
  line?.postMessage(message, transfer);
}

/** Unpacking is slower than a network nearby: all files are fetched at once, and unpacked one after the other. */
function begin(all: Wanted[]): void {
  const steps = all.map((wanted) => {
    const response = fetch(wanted.address).catch(() => null);
    return () => make(wanted, response);
  });
  void steps.reduce((before, next) => before.then(next), Promise.resolve());
}

async function make({ name, size, module }: Wanted, asked: Promise<Response | null>): Promise<void> {
  const response = await asked;
  if (!response?.ok || response.body === null) {
    tell({ kind: "unfetched", name });
    return;
  }
  let came = 0;
  const counting = new TransformStream<Bytes, Bytes>({
    transform: (chunk, out) => {
      came += chunk.length;
      tell({ kind: "counted", bytes: chunk.length });
      out.enqueue(chunk);
    },
  });
  try {
    const bytes = await unpacked(response.body.pipeThrough(counting));
    if (module) tell({ kind: "module", name, module: await WebAssembly.compile(bytes) });
    else tell({ kind: "bytes", name, bytes }, [bytes.buffer]);
  } catch (cause) {
    // The connection may have broken off in the middle of it.
    if (came < size) tell({ kind: "unfetched", name });
    else tell({ kind: "damaged", name, reason: String(cause) });
  }
}
