// Runs a program in MicroPython for WebAssembly, without a line: for what is to be compared or measured.
//
//     node run.mjs MICROPYTHON.mjs FOLDER NAME.py      what it prints goes to standard output; FOLDER is its flash
//
// NAME.py is run, and then its function `step` again and again until that returns false: this build can only collect
// garbage between such calls.

import { readFileSync, readdirSync, writeSync } from "node:fs";
import { join, relative } from "node:path";

const [micropython, folder, name] = process.argv.slice(2);
const { loadMicroPython } = await import(micropython);

const write = (bytes) => {
  for (let at = 0; at < bytes.length;) at += writeSync(1, bytes, at);
};
let out = [];
const flush = () => {
  write(Buffer.from(out));
  out = [];
};
const mp = await loadMicroPython({
  stdout: (bytes) => {
    out.push(...bytes);
    if (out.length > 4096) flush();
  },
  linebuffer: false,
});
mp.FS.mkdir("/flash");
for (const entry of readdirSync(folder, { recursive: true, withFileTypes: true })) {
  const path = `/flash/${relative(folder, join(entry.parentPath, entry.name))}`;
  if (entry.isDirectory()) mp.FS.mkdir(path);
  else mp.FS.writeFile(path, readFileSync(join(entry.parentPath, entry.name)));
}
mp.FS.chdir("/flash");
// Seconds of the processor on this thread, as other benchmarks count them.
globalThis.thread_time_us = () => {
  const { user, system } = process.threadCpuUsage();
  return user + system;
};
try {
  mp.runPython(readFileSync(join(folder, name), "utf8"));
  const step = mp.globals.get("step");
  while (step?.()) flush();
} catch (problem) {
  flush();
  process.stderr.write(`${problem.message}\n`);
  process.exitCode = 1;
}
flush();
