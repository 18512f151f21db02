/**
 * What happens to the open mission outside this page: its file on disk, and other windows that have it open.
 *
 * A file that changed while nothing here is unsaved is offered; with unsaved changes the question comes with the next save.
 */
import { create } from "zustand";

import type { News } from "../api/watch";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { endAll } from "../ui/effects";
import { fileName, question, useDocument } from "./document";
import { loadFromDisk } from "./opening";
import { showDifference } from "./saving";
import { hearOfParts } from "./world-files";

export const useDisk = create<News>(() => ({ path: "", revision: "", others: 0, parts: "", runs: [] }));

/** The revision about which the person was asked, or that the disk had when another mission was opened. */
let settled = "";
/** What our own saves have replaced: news of these may still be on their way, until those of the newest save have come. */
const replaced = new Set<string>();

/** Whether what is on disk is said to be something else than what was opened or saved here. */
export function isOther(
  { path, revision }: Pick<News, "path" | "revision">,
  file: { path: string; revision: string },
): boolean {
  return path === file.path && revision !== file.revision && !replaced.has(revision);
}

export function hearOfDisk(news: News): void {
  useDisk.setState(news);
  if (news.revision === useStudio.getState().file.revision) replaced.clear();
  hearOfParts(news);
  offer();
}

function offer(): void {
  const { path, revision } = useDisk.getState();
  const { file, dirty } = useStudio.getState();
  const { saving, ready, banner } = useDocument.getState();
  if (!ready || saving || dirty || path === "") return;
  if (revision === "" || revision === settled || banner?.kind === "question") return;
  if (!isOther({ path, revision }, file)) return;
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
      const { revision } = useDisk.getState();
      const isAnother = state.file.path !== before.file.path;
      settled = isAnother ? revision : "";
      if (isAnother || state.file.revision === revision) replaced.clear();
      else for (const one of [revision, before.file.revision]) replaced.add(one);
    } else if (state.dirty !== before.dirty) offer();
  });
  const offDocument = useDocument.subscribe((state, before) => {
    if (state.banner === null && before.banner !== null) offer();
  });
  return endAll(offStudio, offDocument);
}
