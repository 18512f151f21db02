/**
 * Printing, however it is asked for: by our menu, by Ctrl+P, or by the browser's own menu.
 *
 * The sheet is made when the browser is about to print, and gone afterwards; until its part of the page is fetched, which
 * happens once everything else is at rest, there is nothing to print but what is seen.
 */
import { complain } from "../shell/document";
import { t } from "../words/words";
import type * as sheetModule from "./sheet/sheet";

type Sheet = typeof sheetModule;

let fetched: Promise<Sheet> | null = null;

function fetchSheet(): Promise<Sheet> {
  fetched ??= import("./sheet/sheet").then(
    (sheet) => {
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

/** Fetches the sheet when the browser has nothing else to do. */
export function preparePrinting(): void {
  const quietly = () => void fetchSheet().catch(() => undefined);
  window.addEventListener("load", () => {
    if ("requestIdleCallback" in window) window.requestIdleCallback(quietly, { timeout: 10_000 });
    else setTimeout(quietly, 2000);
  });
}
