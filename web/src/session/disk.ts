/**
 * What happens to the open mission outside this page: its file on disk, and other windows that have it open.
 *
 * A file that changed while nothing here is unsaved is offered; with unsaved changes the question comes with the next save.
 */
import { create } from "zustand";

import type { News } from "../api/watch";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { fileName, question, useDocument } from "./document";
import { loadFromDisk } from "./opening";
import { showDifference } from "./saving";
import { hearOfParts } from "./world-files";

export const useDisk = create<News>(() => ({ path: "", revision: "", others: 0, parts: "", runs: [] }));

/** A revision that is not worth a word: the person was asked, or it is what our own save has just replaced. */
let settled = "";
/** What our own save has replaced: news of it are from before. */
let overtaken: string | null = null;

/** Whether what is on disk is said to be something else than what was opened or saved here. */
export function isOther({ path, revision }: News, file: { path: string; revision: string }): boolean {
  return path === file.path && revision !== file.revision && revision !== overtaken;
}

export function hearOfDisk(news: News): void {
  useDisk.setState(news);
  hearOfParts(news);
  offer();
}

function offer(): void {
  const { path, revision } = useDisk.getState();
  const { file, dirty } = useStudio.getState();
  const { saving, ready, banner } = useDocument.getState();
  if (!ready || saving || dirty || path === "" || path !== file.path) return;
  if (revision === "" || revision === file.revision || revision === settled || banner?.kind === "question") return;
  const ask = () => {
    question(t("disk.changed", { name: fileName() }), [
      ["disk.load", loadFromDisk],
      ["disk.difference", () => showDifference(ask)],
      [
        "disk.keep",
        () => {
          settled = revision;
        },
      ],
    ]);
  };
  ask();
}

/** Watches what makes an offer due; the returned function ends that. */
export function watchDisk(): () => void {
  const offStudio = useStudio.subscribe((state, before) => {
    // The disk's last word is from before our own save; the next one will be true again.
    if (state.file !== before.file) {
      settled = useDisk.getState().revision;
      overtaken = state.file.revision === before.file.revision ? null : settled;
    } else if (state.dirty !== before.dirty) offer();
  });
  const offDocument = useDocument.subscribe((state, before) => {
    if (state.banner === null && before.banner !== null) offer();
  });
  return () => {
    offStudio();
    offDocument();
  };
}
