/**
 * What a pupil who left leaves behind in this browser: the files of the studio that was in the page. They are deleted by the
 * next page, for this one has them open; the work is with the class by then.
 */
import { homeOf } from "../../api/home";
import { pupilName } from "../../api/token";
import { inPage } from "../../api/transport";

const KEY = "kitrobot.class.left";

/** This pupil's files are of no more use here. */
export function leaveFiles(): void {
  if (!inPage()) return;
  try {
    localStorage.setItem(KEY, homeOf(document.baseURI, pupilName()));
  } catch {
    // Then they stay; no other pupil's page opens them.
  }
}

/** Forgets what the page of this pupil remembered, comments too: who comes back gets another key, and begins anew. */
export function forgetKept(name: string): void {
  try {
    localStorage.removeItem(name);
  } catch {
    // No storage, nothing remembered.
  }
}

/** Deletes what was left. */
export function forgetLeft(): void {
  try {
    const left = localStorage.getItem(KEY);
    if (left === null) return;
    indexedDB.deleteDatabase(left).onsuccess = () => localStorage.removeItem(KEY);
  } catch {
    // No storage, nothing left.
  }
}
