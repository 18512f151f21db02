/**
 * The worker that fetches the packed files of Python, unpacks them and compiles those that are WebAssembly, while the worker with
 * Python in it does something else. It ends when it has them all: the memory that unpacking takes is given back with it.
 */
import { type FromUnpacker, unpacked, type Wanted } from "./unpacking";

type Bytes = Uint8Array<ArrayBuffer>;

const scope = self as unknown as {
  postMessage: (message: FromUnpacker, transfer?: Transferable[]) => void;
  addEventListener: (type: "message", heard: (event: MessageEvent<Wanted[]>) => void) => void;
  close: () => void;
};

/** Unpacking is slower than a network nearby: all files are fetched at once, and unpacked one after the other. */
scope.addEventListener("message", ({ data }) => {
  const all = data.map((wanted) => {
    const response = fetch(wanted.address).catch(() => null);
    return () => make(wanted, response);
  });
  void all.reduce((before, next) => before.then(next), Promise.resolve()).then(() => scope.close());
});

async function make({ name, size, module }: Wanted, asked: Promise<Response | null>): Promise<void> {
  const response = await asked;
  if (!response?.ok || response.body === null) {
    scope.postMessage({ kind: "unfetched", name });
    return;
  }
  let came = 0;
  const counting = new TransformStream<Bytes, Bytes>({
    transform: (chunk, out) => {
      came += chunk.length;
      scope.postMessage({ kind: "counted", bytes: chunk.length });
      out.enqueue(chunk);
    },
  });
  try {
    const bytes = await unpacked(response.body.pipeThrough(counting));
    if (module) scope.postMessage({ kind: "module", name, module: await WebAssembly.compile(bytes) });
    else scope.postMessage({ kind: "bytes", name, bytes }, [bytes.buffer]);
  } catch (cause) {
    // The connection may have broken off in the middle of it.
    if (came < size) scope.postMessage({ kind: "unfetched", name });
    else scope.postMessage({ kind: "damaged", name, reason: String(cause) });
  }
}
