/** Notices about the journal: it fails, the studio came back, or another server answers at its address. */
import { ApiError } from "../api/client";
import { failureWords } from "../api/refusal";
import { type Key, t } from "../i18n/words";
import { dismissBanner, question, useDocument } from "./document";
import { isCutOff, isKept, useLink } from "./journal";
import { save } from "./saving";

/** Says that changes are in no journal at the moment: what is not saved would be lost with the page. */
export function reportJournalFault(cause: unknown, again: () => void): void {
  const why = cause instanceof ApiError ? [failureWords(cause)] : [];
  const choices: [Key, () => void][] = [
    ["banner.save", () => void save()],
    ["banner.retry", again],
  ];
  question(t("journal.failed"), choices, "error", [...why, t("journal.failed-help")].join(" "));
}

/** Says when the server answers again; the returned function ends that. What it does not answer is a strip of its own. */
export function sayWhenBack(): () => void {
  return useLink.subscribe((now, before) => {
    if (isCutOff(before) === isCutOff(now)) return;
    const { banner } = useDocument.getState();
    if (isCutOff(now)) {
      if (banner?.message === t("link.back")) dismissBanner();
    } else if (banner === null || banner.message === t("error.offline")) question(t("link.back"), [], "note");
  });
}

/** The studio started anew, and the page has gone on with it. */
export function sayReturned(): void {
  question(t("journal.returned"), [], "note", isKept() ? t("journal.returned-help") : t("journal.failed"));
}

/** Another server answers at the studio's address. */
export function sayStranger(): void {
  question(t("journal.stranger"), [], "error", t("journal.stranger-help"));
}
