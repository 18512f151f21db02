/** The recording of a real robot's last run, or of the one that is on: as a file to keep, or played at once. */
import { traceApi } from "../../api/traces";
import { reportError } from "../../session/document";
import { openFromComputer } from "../../session/open-requests";
import { download } from "../../ui/download";
import { showRobots } from "./state";
import type { Board } from "./wire";

const LONGEST = 80;

/** What the file is called: the program and the robot. */
export function recordingName({ program, name }: Pick<Board, "program" | "name">): string {
  const stem = [program, name].filter((part) => part !== "").join("-");
  return `${stem.replace(/[^\p{L}\p{N}._-]+/gu, "-").slice(0, LONGEST) || "robot"}.krtrace`;
}

export async function saveRecording(board: Board): Promise<void> {
  try {
    download(recordingName(board), await traceApi.ofRobot(board.address), "application/octet-stream");
  } catch (cause) {
    reportError(cause);
  }
}

/** Plays it in the place of the mission that is open, with the arena in the place of the panel. */
export async function playRecording(board: Board): Promise<void> {
  try {
    const bytes = await traceApi.ofRobot(board.address);
    showRobots(false);
    openFromComputer(new File([bytes], recordingName(board)));
  } catch (cause) {
    reportError(cause);
  }
}
