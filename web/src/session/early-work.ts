/**
 * What is done to a mission before there is a studio that keeps a journal: the browser keeps it, until the journal has it.
 *
 * Only a static site draws a mission so early (`site/first.ts`).
 */
import { isUnsaved } from "../model/history";
import { useStudio } from "../model/studio";
import type { MissionFile } from "../model/types";
import { parseStored, readStored, writeStored } from "../ui/browser-storage";
import { useDocument, whenReady } from "./document";
import { flush, isKept } from "./journal";
import { type Recovered, recordsOf, recover } from "./journal-records";

const KEY = "kitrobot.early";

interface EarlyWork {
  path: string;
  revision: string;
  records: string[];
}

/** Whether the browser keeps early work that no journal has yet. */
export function hasEarlyWork(): boolean {
  return readStored(KEY) !== null;
}

/** What was done to that mission in an earlier visit that ended before the studio was there. */
export function earlyWorkOn({ path, revision }: MissionFile): Recovered | null {
  const work = parseStored(readStored(KEY)) as EarlyWork | null;
  const here = work?.path === path && work.revision === revision && Array.isArray(work.records);
  return here ? recover(work.records) : null;
}

function store(): void {
  const { file, history } = useStudio.getState();
  const { path, revision } = file;
  const isNone = !isUnsaved(history) && history.future.length === 0;
  const text = isNone ? null : JSON.stringify({ path, revision, records: recordsOf(history, revision) });
  writeStored(KEY, text);
  // Without room for it there is none, and leaving the page asks.
  if (readStored(KEY) !== text) writeStored(KEY, null);
}

/** Keeps what is done to the drawn mission; `kept` is called once the journal has it. */
export function keepEarlyWork(kept: () => void): void {
  const offStudio = useStudio.subscribe(({ change }, before) => {
    if (change !== before.change && useDocument.getState().ahead) store();
  });
  void whenReady().then(async () => {
    offStudio();
    await flush();
    if (!hasEarlyWork() || !isKept()) return;
    writeStored(KEY, null);
    kept();
  });
}
