/** What is open when the page begins: the work of this tab before, what the command line named, or what the folder has. */
import { api } from "../api/client";
import type { Session } from "../api/generated";
import { journalApi } from "../api/journal";
import { rememberSecret } from "../api/reconnect";
import { traceApi } from "../api/traces";
import { reportError, show, startSession } from "../session/document";
import { journalBefore, keepsJournal } from "../session/journal";
import { holdUntil, offerLeft } from "../session/open-requests";
import { take, takeLeft } from "../session/opening";
import { begin as play, isRecording } from "../session/recordings";

/** What the address names, for a page that another `kitrobot` opened: null when it names nothing, "" for the folder. */
function namedInAddress(): string | null {
  return new URL(window.location.href).searchParams.get("open");
}

/** It is open: what happens to the page from now on counts more. */
function forgetNamed(): void {
  const address = new URL(window.location.href);
  address.searchParams.delete("open");
  window.history.replaceState(window.history.state, "", address);
}

/** The first mission: the one of the command line, else one of the folder. */
export function begin(): Promise<void> {
  return holdUntil(openFirst());
}

async function openFirst(): Promise<void> {
  try {
    const said = await api.session();
    rememberSecret(said.secret);
    const named = namedInAddress();
    const session = named === null ? said : { ...said, path: named || null };
    startSession(session);
    const back = await beginWhereItEnded(session);
    if (!back && session.path === null) await beginInFolder();
    else if (!back && session.path !== null) await beginWith(session.path);
    if (named !== null) forgetNamed();
    if (back) return;
    if (keepsJournal()) offerLeft(await journalApi.left());
  } catch (cause) {
    reportError(cause, () => void begin());
  }
}

/** The folder's only mission; of several the person chooses; where there is none a new one begins. */
async function beginInFolder(): Promise<void> {
  const [first, ...others] = (await api.missions()).filter(({ example, problem }) => !example && problem === "");
  if (first !== undefined && others.length === 0) {
    await beginWith(first.path);
    return;
  }
  await take(await api.newMission());
  show(first === undefined ? "new" : "open");
}

/**
 * The work of this tab before it was loaded again, else, when no mission was named, the newest that was left behind. False
 * when there is none.
 */
async function beginWhereItEnded(session: Session): Promise<boolean> {
  if (!keepsJournal()) return false;
  const before = journalBefore();
  if (before !== "" && (await takeLeft(before))) return true;
  const left = session.path === null ? await journalApi.left() : [];
  const newest = left.find(({ problem }) => problem === "");
  return newest !== undefined && takeLeft(newest.journal);
}

/** A file that cannot be read leaves an empty mission, and the sentence about it above. */
async function beginWith(path: string): Promise<void> {
  try {
    if (isRecording(path)) {
      const found = await traceApi.open(path);
      await take(found.file);
      play(found);
    } else {
      await take(await api.mission(path));
    }
  } catch (cause) {
    await take(await api.newMission());
    reportError(cause);
  }
}
