/** What menus and keys do with real robots; the rest is fetched when it is first wanted. */
import { moreWords } from "../../i18n/words";
import { complain } from "../../session/document";
import { showRobots } from "./state";

/** Sends to every robot that is connected, and runs; where none is, the panel says what to do. */
export function runOnRobots(): void {
  showRobots();
  Promise.all([import("./actions"), moreWords()]).then(([{ runOnAll }]) => runOnAll(), complain);
}
