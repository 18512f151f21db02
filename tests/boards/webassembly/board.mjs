// A board on this computer: MicroPython for WebAssembly behind a TCP port on loopback, which is its serial line.
//
//     node board.mjs MICROPYTHON.mjs GIVEN.json       GIVEN: {port, files: {name: base64}, pace}
//
// Says {"address": "socket://127.0.0.1:PORT"} on standard output, then an answer to each line of standard input:
// "cut" takes its power away, at once, whatever it does, and gives it back; "files" tells what its flash holds; "deaf" has
// its host take nothing any more, "hears" ends that, and both tell how often a program was refused room for what it would
// say, and how often one was held up. It ends with its standard input. What happens on the board is in interpreter.mjs, in a thread of its own, so that a program
// that never ends there does not stop the line here. Its flash is kept here: a file is in it once it was closed.

import { createInterface } from "node:readline";
import { createServer } from "node:net";
import { readFileSync } from "node:fs";
import { Worker } from "node:worker_threads";
import { DEAF, HEAD, HELD_UP, REFUSED, RING_BYTES, TAIL, ringOf } from "./ring.mjs";

const [micropython, givenPath] = process.argv.slice(2);
const given = JSON.parse(readFileSync(givenPath, "utf8"));
const compiled = await WebAssembly.compile(readFileSync(micropython.replace(/\.mjs$/, ".wasm")));
const flash = new Map(Object.entries(given.files ?? {}).map(([name, text]) => [name, Buffer.from(text, "base64")]));

let host; // the socket of who is connected
let worker;
let ring;
let waiting = []; // bytes for which the ring has no room yet
let unheard = []; // what was said before anybody ever listened, or while nobody did
let wasHeard = false;
const isDeaf = () => Atomics.load(ring.indices, DEAF) === 1;

const say = (answer) => process.stdout.write(JSON.stringify(answer) + "\n");

function tell(bytes) {
  if (isDeaf() || (host === undefined && !wasHeard)) unheard.push(bytes);
  else host?.write(bytes);
}

function powerUp() {
  ring = ringOf(new SharedArrayBuffer(RING_BYTES));
  waiting = [];
  const begun = new Worker(new URL("./interpreter.mjs", import.meta.url), {
    workerData: { micropython, compiled, buffer: ring.buffer, files: [...flash], pace: given.pace },
  });
  worker = begun;
  begun.on("message", (message) => {
    if (begun !== worker) return; // it has no power any more
    if (message.out !== undefined) tell(message.out);
    else if (message.put !== undefined) flash.set(message.put, Buffer.from(message.bytes));
    else if (message.remove !== undefined) flash.delete(message.remove);
  });
  begun.on("exit", (code) => {
    if (begun !== worker) return;
    process.stderr.write(`the board's thread ended: ${code}\n`);
    process.exit(1);
  });
  begun.on("error", (problem) => {
    process.stderr.write(`${problem?.stack ?? problem}\n`);
    process.exit(1);
  });
}

function deliver() {
  const { indices, bytes } = ring;
  let head = Atomics.load(indices, HEAD);
  const room = bytes.length - (head - Atomics.load(indices, TAIL));
  for (const byte of waiting.splice(0, room)) bytes[head++ % bytes.length] = byte;
  Atomics.store(indices, HEAD, head);
  Atomics.notify(indices, HEAD);
  if (waiting.length > 0) {
    const line = ring;
    const tail = Atomics.load(indices, TAIL);
    void Promise.resolve(Atomics.waitAsync(indices, TAIL, tail).value).then(() => line === ring && deliver());
  }
}

const server = createServer((socket) => {
  host?.destroy();
  host = socket;
  socket.setNoDelay(true);
  wasHeard = true;
  for (const bytes of unheard.splice(0)) socket.write(bytes);
  socket.on("data", (data) => {
    waiting.push(...data);
    deliver();
  });
  socket.on("error", () => {});
  socket.on("close", () => {
    if (host === socket) host = undefined;
  });
});

const said = () => ({
  refused: Atomics.load(ring.indices, REFUSED),
  heldUp: Atomics.load(ring.indices, HELD_UP),
});

const commands = {
  cut: async () => {
    const old = worker;
    worker = undefined;
    await old.terminate();
    powerUp();
    return { cut: true };
  },
  deaf: () => {
    Atomics.store(ring.indices, DEAF, 1);
    return said();
  },
  hears: () => {
    Atomics.store(ring.indices, DEAF, 0);
    Atomics.notify(ring.indices, DEAF);
    for (const bytes of unheard.splice(0)) host?.write(bytes);
    return said();
  },
  said,
  files: () => ({ files: Object.fromEntries([...flash].map(([name, bytes]) => [name, bytes.toString("base64")])) }),
};

server.listen(given.port ?? 0, "127.0.0.1", () => {
  powerUp();
  say({ address: `socket://127.0.0.1:${server.address().port}` });
});

for await (const line of createInterface({ input: process.stdin })) {
  say((await commands[line.trim()]?.()) ?? { unknown: line });
}
process.exit(0);
