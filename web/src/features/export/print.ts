/**
 * Printing, however it is asked for: by our menu, by Ctrl+P, or by the browser's own menu.
 *
 * The sheet is made when the browser is about to print, and gone afterwards; until its part of the page is fetched, which
 * begins after the first key or click, there is nothing to print but what is seen.
 */
import { moreWords, t } from "../../i18n/words";
import { reportError } from "../../session/document";
import { whenIdle } from "../../ui/idle";

const fetchSheet = once(async () => {
  const [sheet] = await Promise.all([import("./sheet/sheet"), moreWords()]);
  return sheet.keepSheet();
});

/** Does it once; what has failed (cut off from the server) is tried again by the next wish. */
function once<T>(act: () => Promise<T>): () => Promise<T> {
  let done: Promise<T> | null = null;
  return () =>
    (done ??= act().catch((cause: unknown) => {
      done = null;
      throw cause;
    }));
}

export function printSheet(): void {
  fetchSheet()
    .then((print) => print())
    .catch(() => {
      reportError(new Error(t("out.print-failed")));
    });
}

/**
 * Fetches the sheet after the first key or click: the browser's own printing leaves no time for it. The returned function ends
 * the waiting.
 */
export function preparePrinting(): () => void {
  const signs = ["pointerdown", "keydown"] as const;
  const end = () => {
    for (const sign of signs) window.removeEventListener(sign, quietly, true);
  };
  const quietly = () => {
    end();
    // What was clicked comes first.
    whenIdle(() => void fetchSheet().catch(() => undefined));
  };
  for (const sign of signs) window.addEventListener(sign, quietly, true);
  return end;
}
