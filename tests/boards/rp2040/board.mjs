// A Raspberry Pi Pico on this computer: its processor and what is around it, emulated by rp2040js, behind a TCP port on loopback.
//
//     node board.mjs RP2040JS.js GIVEN.json       GIVEN: {port, firmware: "….uf2", bootrom: "….bin"}
//
// Says {"address": "socket://127.0.0.1:PORT"} on standard output, then an answer to each line of standard input: "cut" takes
// its power away and gives it back, "time" tells the seconds of its own clock, "pins" how each pin stands. It ends with its
// standard input. The line is its USB serial port, or UART 0 as long as no USB host is served.
//
// The emulator knows no flash chip that is written: the functions of the boot ROM that erase and program are done here, when
// the processor comes to them. Its clock is never ahead of the real one; on a slow machine it is behind, and a host must go
// by it.

import { createInterface } from "node:readline";
import { createServer } from "node:net";
import { readFileSync } from "node:fs";

const FLASH = 0x10000000;
const PAGE = 256; // bytes that are programmed at once
const NANOS_A_CYCLE = 8; // 125 MHz
const AT_ONCE = 50_000; // instructions, before the line is looked at
const LONGEST_REST = 1_000_000; // ns that a processor waits at once
const PWM_BASE = 0x40050000;
const [MAGIC, NOT_FLASH, UF2_BLOCK] = [0x0a324655, 1, 512];

const [emulator, givenPath] = process.argv.slice(2);
const given = JSON.parse(readFileSync(givenPath, "utf8"));
const { RP2040, USBCDC } = await import(emulator);
const bootrom = hooked(readFileSync(given.bootrom));
const flash = Buffer.alloc(16 * 1024 * 1024, 0xff);
load(readFileSync(given.firmware));

let host;
let pico;
let cdc;
let hasUsb = false;
let waiting = [];
let base = 0; // ns on its clock before the power was cut last
const began = process.hrtime.bigint();

const say = (answer) => process.stdout.write(JSON.stringify(answer) + "\n");

function load(uf2) {
  for (let at = 0; at + UF2_BLOCK <= uf2.length; at += UF2_BLOCK) {
    if (uf2.readUInt32LE(at) !== MAGIC) throw new Error("the firmware is no UF2 file");
    if ((uf2.readUInt32LE(at + 8) & NOT_FLASH) !== 0) continue;
    const size = uf2.readUInt32LE(at + 16);
    uf2.copy(flash, uf2.readUInt32LE(at + 12) - FLASH, at + 32, at + 32 + size);
  }
}

/** The boot ROM with a breakpoint in the place of each function that deals with the flash chip; its number says which. */
function hooked(rom) {
  const hooks = ["IF", "EX", "RE", "RP", "FC", "CX"];
  for (let at = rom.readUInt16LE(0x14); rom.readUInt16LE(at) !== 0; at += 4) {
    const number = hooks.indexOf(String.fromCharCode(rom[at], rom[at + 1]));
    if (number >= 0) rom.writeUInt16LE(0xbe00 | number, rom.readUInt16LE(at + 2) & ~1);
  }
  return new Uint32Array(rom.buffer.slice(rom.byteOffset, rom.byteOffset + rom.length));
}

function called(number) {
  const { core, flash: chip } = pico;
  const [at, second, third] = core.registers;
  if (number === 2) chip.fill(0xff, at, at + second);
  else if (number === 3) {
    for (let i = 0; i < third; i += 1) chip[at + i] &= pico.readUint8(second + i);
    if (at % PAGE !== 0 || third % PAGE !== 0) process.stderr.write("a part of a page of flash was programmed\n");
  }
  core.PC = core.LR & ~1;
}

function powerUp() {
  pico = new RP2040();
  pico.logger = { debug() {}, info() {}, warn() {}, error() {} };
  pico.loadBootrom(bootrom);
  pico.flash.set(flash);
  pico.onBreak = called;
  hasUsb = false;
  cdc = new USBCDC(pico.usbCtrl);
  cdc.onDeviceConnected = () => (hasUsb = true);
  cdc.onSerialData = (bytes) => host?.write(bytes);
  pico.uart[0].onByte = (byte) => hasUsb || host?.write(Buffer.from([byte]));
  pico.core.PC = FLASH; // where the boot ROM goes when BOOTSEL is not pressed
}

function deliver() {
  const room = hasUsb ? cdc.txFIFO : pico.uart[0].rxFIFO;
  while (waiting.length > 0 && !room.full) {
    if (hasUsb) cdc.sendSerialByte(waiting.shift());
    else pico.uart[0].feedByte(waiting.shift());
  }
}

const now = () => base + pico.clock.nanos;

function run() {
  deliver();
  const { core, clock } = pico;
  for (let i = 0; i < AT_ONCE; i += 1) {
    if (!core.waiting) clock.tick(core.executeInstruction() * NANOS_A_CYCLE);
    else {
      const left = clock.nanosToNextAlarm;
      clock.tick(left > 0 ? Math.min(left, LONGEST_REST) : LONGEST_REST);
      break;
    }
  }
  const ahead = now() - Number(process.hrtime.bigint() - began);
  if (ahead > LONGEST_REST) setTimeout(run, ahead / 1e6);
  else setImmediate(run);
}

/** How a pin stands: the number of its function, its level, and for a wave the part of the time that it is on. */
function standing(pin) {
  const at = PWM_BASE + 20 * ((pin.index >> 1) & 7);
  const level = (pico.readUint32(at + 12) >>> (16 * (pin.index & 1))) & 0xffff;
  return { function: pin.functionSelect, level: pin.value, duty: level / ((pico.readUint32(at + 16) & 0xffff) + 1) };
}

const commands = {
  cut: () => {
    base = now();
    flash.set(pico.flash);
    waiting = [];
    powerUp();
    return { cut: true };
  },
  time: () => ({ seconds: now() / 1e9 }),
  pins: () => ({ pins: pico.gpio.map(standing) }),
};

const server = createServer((socket) => {
  host?.destroy();
  host = socket;
  socket.setNoDelay(true);
  socket.on("data", (data) => waiting.push(...data));
  socket.on("error", () => {});
  socket.on("close", () => {
    if (host === socket) host = undefined;
  });
});
server.listen(given.port ?? 0, "127.0.0.1", () => {
  powerUp();
  say({ address: `socket://127.0.0.1:${server.address().port}` });
  run();
});

for await (const line of createInterface({ input: process.stdin })) say(commands[line.trim()]?.() ?? { unknown: line });
process.exit(0);
