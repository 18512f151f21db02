/** What menus and keys do with real robots; the rest is fetched when it is first wanted. */
import { moreWords } from "../../i18n/words";
import { complain } from "../../session/document";
import { showRobots } from "./state";

/** Asks in the panel what the robot is built of, and saves the file for a board's drive. */
export function saveFileForBoard(): void {
  showRobots();
  Promise.all([import("./board-file"), moreWords()]).then(([{ saveBoardFile }]) => {
    saveBoardFile();
  }, complain);
}

/** Sends to every robot that is connected, and runs; where none is, the panel says what to do. */
export function runOnRobots(): void {
  showRobots();
  Promise.all([import("./actions"), moreWords()]).then(([{ runOnAll }]) => runOnAll(), complain);
}
