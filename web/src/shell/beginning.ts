/** What is open when the page begins: the work of this tab before, what the command line named, or something to try. */
import { api, type Session } from "../api/client";
import { journalApi } from "../api/journal";
import { traceApi } from "../api/traces";
import { complain, holdUntil, offerLeft, take, takeLeft, useDocument } from "./document";
import { journalBefore, keepsJournal } from "./journal";
import { begin as play, isRecording } from "./recordings";

/** The first mission: the one of the command line, else the first example, else an empty one. */
export function begin(): Promise<void> {
  return holdUntil(openFirst());
}

async function openFirst(): Promise<void> {
  try {
    const session = await api.session();
    useDocument.setState({ session });
    if (await beginWhereItEnded(session)) return;
    if (session.path === null) {
      const example = (await api.missions()).find((entry) => entry.example);
      await take(example === undefined ? await api.newMission() : await api.mission(example.path));
    } else {
      await beginWith(session.path);
    }
    if (keepsJournal()) offerLeft(await journalApi.left());
  } catch (cause) {
    complain(cause, () => void begin());
  }
}

/**
 * The work of this tab before it was loaded again, else, when no mission was named, the newest that was left behind. False
 * when there is none.
 */
async function beginWhereItEnded(session: Session): Promise<boolean> {
  if (!keepsJournal()) return false;
  const before = journalBefore();
  if (before !== "" && (await takeLeft(before))) return true;
  const [newest] = session.path === null ? await journalApi.left() : [];
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
    complain(cause);
  }
}
