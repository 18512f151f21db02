// The board itself, in a thread: boot.py and main.py at power-on, then the prompt, with everything a host may ask of it.
//
// The interpreter is MicroPython's own, as are its prompt, its raw REPL and its modules. What a microcontroller's port
// adds is here: bytes that come in while a program runs (and Ctrl+C among them), `sys.stdin` that can be polled, files
// that outlast a reset, soft reset, and raw paste mode, which this build announces but cannot do.

import { parentPort, workerData } from "node:worker_threads";
import { DEAF, HEAD, HELD_UP, REFUSED, TAIL, ringOf } from "./ring.mjs";

const CTRL_A = 1;
const CTRL_B = 2;
const CTRL_C = 3;
const CTRL_D = 4;
const CTRL_E = 5;
const FORCED_EXIT = 0x100; // what the prompt answers when a soft reset is asked for
const POLLIN = 1;
const POLLOUT = 4;
const ROOT = "/flash";
const RAW_BANNER = "raw REPL; CTRL-B to exit\r\n>";
const PASTE_WINDOW = 128;
const OUT_BYTES = 256; // what USB keeps of what goes out, for a host that takes nothing
const OUT_WAIT_MS = 500; // then a program that writes more waits so long, and its bytes are lost
const IDLE_CALLS = 40; // who looks at the clock or at its line so often in one millisecond has nothing to do

// Runs a file of the board as its firmware does: uncaught exceptions are shown; Ctrl+C ends it.
const RUN = (name) => `
def _run(name):
    import micropython, sys
    try:
        with open(name) as file:
            text = file.read()
    except OSError:
        return
    micropython.kbd_intr(3)
    try:
        exec(compile(text, name, "exec"), globals())
    except SystemExit:
        pass
    except BaseException as error:
        sys.print_exception(error)
    micropython.kbd_intr(-1)
_run(${JSON.stringify(name)})
del _run
`;

// Its WebAssembly was compiled once for all starts of the board, in any thread.
WebAssembly.instantiate = async (binary, imports) => ({
  module: workerData.compiled,
  instance: await new WebAssembly.Instance(workerData.compiled, imports),
});
const { loadMicroPython } = await import(workerData.micropython);
const { indices, bytes } = ringOf(workerData.buffer);
const files = new Map(workerData.files);

let mp;
let heard = []; // came in, from `taken` on nobody has read it yet
let taken = 0;
let out = [];
let muted = false;
let skip = 0; // bytes that are not to be said
let tail = ""; // the end of what was said
let raw = false;
let typed = 0; // bytes since the raw prompt
let paste = []; // the beginning of a request for raw paste

function flush() {
  if (out.length === 0) return;
  parentPort.postMessage({ out: new Uint8Array(out) });
  out = [];
}

let kept = 0; // bytes that went out since the host takes nothing

/** Whether there is room for one more byte. */
function hasRoom() {
  if (Atomics.load(indices, DEAF) === 0) kept = 0;
  return kept < OUT_BYTES;
}

function put(data) {
  for (const byte of data) {
    if (!hasRoom()) {
      flush();
      Atomics.add(indices, HELD_UP, 1);
      if (Atomics.wait(indices, DEAF, 1, OUT_WAIT_MS) === "timed-out") return;
    }
    kept += 1;
    tail = (tail + String.fromCharCode(byte)).slice(-RAW_BANNER.length);
    if (skip > 0) skip -= 1;
    else if (!muted) out.push(byte);
  }
  if (out.length > 512) flush();
}

/** Takes what came in, as the interrupt of a serial line does: the interrupt character interrupts. */
function pump() {
  flush();
  const head = Atomics.load(indices, HEAD);
  let at = Atomics.load(indices, TAIL);
  if (head === at) return false;
  let interrupted = false;
  for (; at !== head; at += 1) {
    const byte = bytes[at % bytes.length];
    if (mp !== undefined && byte === mp._module._mp_hal_get_interrupt_char()) {
      mp._module._mp_sched_keyboard_interrupt();
      interrupted = true;
    } else heard.push(byte);
  }
  Atomics.store(indices, TAIL, at);
  Atomics.notify(indices, TAIL);
  return interrupted;
}

/** Sleeps until something comes in, at most so long; for ever without a limit. */
function rest(ms) {
  Atomics.wait(indices, HEAD, Atomics.load(indices, TAIL), ms);
}

/** The next of the bytes that came in, of which there is one. */
function take() {
  const byte = heard[taken];
  taken += 1;
  if (taken === heard.length) {
    heard = [];
    taken = 0;
  }
  return byte;
}

/** The next byte for a program that waits for one; null when it was interrupted meanwhile. */
function readByte() {
  for (;;) {
    if (pump()) return null;
    if (heard.length > 0) return take();
    rest();
  }
}

const real = Date.now.bind(Date);
const begun = real();
const { pace } = workerData;
/** What the board's clock shows, which goes `pace` times slower than this computer's. */
const clock = () => Math.floor(begun + (real() - begun) / pace);
let last = 0;
let calls = 0;

/** Lets a program that only waits sleep for a moment. */
function idle() {
  const now = real();
  calls = now === last ? calls + 1 : 0;
  last = now;
  if (calls > IDLE_CALLS) {
    calls = 0;
    rest(1);
  }
}

// The one thing that every waiting program does is to look at the clock.
Date.now = () => {
  pump();
  idle();
  return clock();
};

function watchFiles(fs) {
  const close = fs.close;
  const unlink = fs.unlink;
  const rename = fs.rename;
  const short = (path) => (path.startsWith(`${ROOT}/`) ? path.slice(ROOT.length + 1) : undefined);
  const whole = (path) => (path.startsWith("/") ? path : `${fs.cwd()}/${path}`.replaceAll("//", "/"));
  const keep = (path) => {
    const name = short(path);
    if (name === undefined) return;
    files.set(name, fs.readFile(path));
    parentPort.postMessage({ put: name, bytes: files.get(name) });
  };
  const forget = (path) => {
    const name = short(path);
    if (name === undefined || !files.delete(name)) return;
    parentPort.postMessage({ remove: name });
  };
  fs.close = (stream) => {
    const written = (stream.flags & 3) !== 0 && fs.isFile(stream.node?.mode ?? 0) ? stream.path : undefined;
    close.call(fs, stream);
    if (written !== undefined) keep(written);
  };
  fs.unlink = (path) => {
    unlink.call(fs, path);
    forget(whole(path));
  };
  fs.rename = (from, to) => {
    rename.call(fs, from, to);
    forget(whole(from));
    keep(whole(to));
  };
}

async function boot(withMain) {
  mp = undefined;
  // Node's loop must turn once, or what the old one held is never given back.
  await new Promise((resolve) => setImmediate(resolve));
  mp = await loadMicroPython({ stdin: readByte, stdout: put, stderr: put, linebuffer: false });
  const stdin = mp.FS.streams[0];
  stdin.stream_ops = {
    ...stdin.stream_ops,
    poll: () => {
      pump();
      idle();
      return (heard.length > 0 ? POLLIN : 0) | POLLOUT;
    },
  };
  const stdout = mp.FS.streams[1];
  stdout.stream_ops = {
    ...stdout.stream_ops,
    poll: () => {
      if (hasRoom()) return POLLOUT;
      Atomics.add(indices, REFUSED, 1);
      return 0;
    },
  };
  mp.FS.mkdir(ROOT);
  for (const [name, content] of files) {
    const folders = name.split("/").slice(0, -1);
    for (let i = 1; i <= folders.length; i += 1) {
      const folder = `${ROOT}/${folders.slice(0, i).join("/")}`;
      if (!mp.FS.analyzePath(folder).exists) mp.FS.mkdir(folder);
    }
    mp.FS.writeFile(`${ROOT}/${name}`, content);
  }
  mp.FS.chdir(ROOT);
  watchFiles(mp.FS);
  mp.runPython(`import sys\nsys.path[:] = ["", "/flash/lib", ".frozen"]\ndel sys`);
  mp.runPython(RUN("boot.py"));
  if (withMain) mp.runPython(RUN("main.py"));
  muted = !withMain;
  mp.replInit();
  muted = false;
  raw = false;
  typed = 0;
  if (!withMain) say(CTRL_A);
  flush();
}

/** Raw paste mode: the host sends no more than a window ahead. Then the text runs as in the raw REPL. */
function takePaste() {
  put([0x52, 1, PASTE_WINDOW, 0, 1]);
  const text = [];
  for (;;) {
    const byte = readByte();
    if (byte === CTRL_C) {
      put([CTRL_D]);
      text.length = 0;
      break;
    }
    if (byte === CTRL_D) {
      put([CTRL_D]);
      break;
    }
    text.push(byte);
    if (text.length % PASTE_WINDOW === 0) put([1]);
  }
  if (text.length === 0) text.push(0x20);
  for (const byte of text) mp.replProcessChar(byte);
  skip = 2; // the raw REPL says OK first, which raw paste does not
  return mp.replProcessChar(CTRL_D);
}

/** Gives a byte to the prompt; whether it asks for a soft reset. */
function say(byte) {
  if (raw && typed === 0) {
    const wanted = [CTRL_E, 0x41, CTRL_A];
    if (byte === wanted[paste.length]) {
      paste.push(byte);
      if (paste.length < wanted.length) return false;
      paste = [];
      return (takePaste() & FORCED_EXIT) !== 0;
    }
    for (const held of paste) mp.replProcessChar(held);
    typed += paste.length;
    paste = [];
  }
  const result = mp.replProcessChar(byte);
  typed = byte <= CTRL_D ? 0 : typed + 1;
  if (byte === CTRL_A && tail.endsWith(RAW_BANNER)) raw = true;
  if (byte === CTRL_B && tail.endsWith(">>> ")) raw = false;
  return (result & FORCED_EXIT) !== 0;
}

await boot(true);
for (;;) {
  const byte = readByte();
  if (byte !== null && say(byte)) {
    put(new TextEncoder().encode("MPY: soft reboot\r\n"));
    await boot(!raw);
  }
}
