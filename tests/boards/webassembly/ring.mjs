// Bytes from one thread to another. HEAD counts what was put in, TAIL what was taken out; each is written by one thread.

export const HEAD = 0;
export const TAIL = 1;
const INDICES_BYTES = 8;
export const RING_BYTES = INDICES_BYTES + 65536;

export const ringOf = (buffer) => ({
  buffer,
  indices: new Int32Array(buffer, 0, 2),
  bytes: new Uint8Array(buffer, INDICES_BYTES),
});
