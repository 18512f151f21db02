/** Routes of firmware: boards that show a drive for it, and MicroPython copied to one. */
import { ask } from "./client";
import type { Firmware, Flashed } from "./generated";

export const firmwareApi = {
  look: () => ask<Firmware>("firmware"),
  flash: (file: string, drive: string, bytes: ArrayBuffer) =>
    ask<Flashed>(`firmware?file=${encodeURIComponent(file)}&drive=${encodeURIComponent(drive)}`, {
      method: "POST",
      bytes,
    }),
};
