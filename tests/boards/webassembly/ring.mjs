// Bytes from one thread to another. HEAD counts what was put in, TAIL what was taken out; each is written by one thread.

export const HEAD = 0;
export const TAIL = 1;
// What goes out: 1 while the host takes nothing; how often a program asked for room then and there was none; how
// often one wrote all the same, and waited.
export const DEAF = 2;
export const REFUSED = 3;
export const HELD_UP = 4;
const INDICES_BYTES = 20;
export const RING_BYTES = INDICES_BYTES + 65536;

export const ringOf = (buffer) => ({
  buffer,
  indices: new Int32Array(buffer, 0, 5),
  bytes: new Uint8Array(buffer, INDICES_BYTES),
});
