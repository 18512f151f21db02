/**
 * The program in view as a file that is copied onto the drive of a board: for whoever may plug nothing in, from any
 * computer or tablet. The file for a micro:bit has its MicroPython; that for other boards gets the one that the reader
 * has, a file that is asked for once while the page is open (`BoardFileSheet`).
 */
import { create } from "zustand";

import { api } from "../../api/client";
import type { KitEntry } from "../../api/generated";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { note, reportError } from "../../session/document";
import { download } from "../../ui/download";
import { kitFor, programFor, useBoards } from "./boards";
import { askKit, knownKit } from "./kits";

/** In the place of a robot's address: nobody knows yet which board it will be. */
const DRIVE = "drive:";
/** Bytes that become letters at once. */
const PIECE = 0x8000;

/** The kit whose board needs a MicroPython in its file, and the one that was chosen last; null: nothing is asked, none was. */
export const useFirmwareQuestion = create<{ kit: KitEntry | null; file: File | null }>(() => ({
  kit: null,
  file: null,
}));

/** Asks what the robot is built of, and for its MicroPython where that comes along, then saves. */
export function saveBoardFile(): void {
  askKit(DRIVE, () => {
    const name = kitFor(useBoards.getState(), DRIVE);
    const kit = knownKit(name);
    if (kit?.file === ".uf2") useFirmwareQuestion.setState({ kit });
    else saveFor(name, null).catch(reportError);
  });
}

/** Nothing is saved. */
export function dropFirmwareQuestion(): void {
  useFirmwareQuestion.setState({ kit: null });
}

export function chooseFirmware(file: File): void {
  useFirmwareQuestion.setState({ file });
}

/** Saves with that MicroPython; the question stays where it cannot be used. */
export async function saveWithFirmware(kit: KitEntry, file: File): Promise<void> {
  await saveFor(kit.name, { name: file.name, bytes: await file.arrayBuffer() });
  dropFirmwareQuestion();
}

async function saveFor(kit: string, firmware: { name: string; bytes: ArrayBuffer } | null): Promise<void> {
  const { mission, file, activeProgram } = useStudio.getState();
  const names = mission.programs.map(({ name }) => name);
  const program = programFor(useBoards.getState(), DRIVE, names, activeProgram);
  const made = await api.boardFile({
    ...{ mission, path: file.path, program, kit },
    firmware: firmware === null ? "" : base64(new Uint8Array(firmware.bytes)),
    firmware_name: firmware?.name.slice(-200) ?? "",
  });
  const name = `${program}${made.ending}`;
  download(
    name,
    Uint8Array.from(atob(made.file), (letter) => letter.charCodeAt(0)),
    "application/octet-stream",
  );
  note(t("board-file.saved", { name, boards: made.boards }), [...made.reasons, made.steps].join(" "));
}

function base64(bytes: Uint8Array): string {
  let letters = "";
  for (let at = 0; at < bytes.length; at += PIECE) {
    letters += String.fromCharCode(...bytes.subarray(at, at + PIECE));
  }
  return btoa(letters);
}
