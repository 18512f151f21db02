/**
 * Printing, however it is asked for: by our menu, by Ctrl+P, or by the browser's own menu.
 *
 * The sheet is made when the browser is about to print, and gone afterwards; until its part of the page is fetched, which
 * begins with the first key or click, there is nothing to print but what is seen.
 */
import { moreWords, t } from "../../i18n/words";
import { complain } from "../../session/document";
import type * as sheetModule from "./sheet/sheet";

type Sheet = typeof sheetModule;

let fetched: Promise<Sheet> | null = null;

function fetchSheet(): Promise<Sheet> {
  fetched ??= Promise.all([import("./sheet/sheet"), moreWords()]).then(
    ([sheet]) => {
      sheet.keepSheet();
      return sheet;
    },
    (cause: unknown) => {
      // Cut off from the server: the next wish tries again.
      fetched = null;
      throw cause;
    },
  );
  return fetched;
}

export function printSheet(): void {
  fetchSheet()
    .then((sheet) => sheet.print())
    .catch(() => {
      complain(new Error(t("out.print-failed")));
    });
}

/**
 * Fetches the sheet at the first key or click: the browser's own printing leaves no time for it. The returned function ends
 * the waiting.
 */
export function preparePrinting(): () => void {
  const signs = ["pointerdown", "keydown"] as const;
  const end = () => {
    for (const sign of signs) window.removeEventListener(sign, quietly, true);
  };
  const quietly = () => {
    end();
    void fetchSheet().catch(() => undefined);
  };
  for (const sign of signs) window.addEventListener(sign, quietly, true);
  return end;
}
