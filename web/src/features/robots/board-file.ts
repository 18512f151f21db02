/**
 * The program in view as a file that is copied onto the drive of a micro:bit: for whoever may plug nothing in, from any
 * computer or tablet.
 */
import { api } from "../../api/client";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { complain, note } from "../../session/document";
import { download } from "../../ui/download";
import { kitFor, programFor, useBoards } from "./boards";
import { askKit } from "./kits";

/** In the place of a robot's address: nobody knows yet which board it will be. */
const DRIVE = "drive:";

/** Asks what the robot is built of, then saves. */
export function saveBoardFile(): void {
  askKit(DRIVE, () => void saveFor(kitFor(useBoards.getState(), DRIVE)));
}

async function saveFor(kit: string): Promise<void> {
  const { mission, file, activeProgram } = useStudio.getState();
  const names = mission.programs.map(({ name }) => name);
  const program = programFor(useBoards.getState(), DRIVE, names, activeProgram);
  try {
    const made = await api.boardFile(mission, file.path, program, kit);
    const bytes = Uint8Array.from(atob(made.file), (letter) => letter.charCodeAt(0));
    download(`${program}.hex`, bytes, "application/octet-stream");
    note(
      t("board-file.saved", { name: `${program}.hex`, boards: made.boards }),
      [...made.reasons, t("board-file.copy")].join(" "),
    );
  } catch (cause) {
    complain(cause);
  }
}
