/**
 * The mission that a new studio begins with, drawn and edited before Python is there: `kitrobot site` writes the answer that
 * Python will give into the folder. That is true only as long as nothing was ever done in this browser that Python knows.
 */
import { pageRole } from "../api/token";
import { languageInUse } from "../i18n/words";
import { useStudio } from "../model/studio";
import type { MissionFile } from "../model/types";
import { useDocument } from "../session/document";
import { earlyWorkOn, hasEarlyWork, keepEarlyWork } from "../session/early-work";
import { drawAhead } from "../session/opening";
import { readStored, writeStored } from "../ui/browser-storage";
import { whenIdle } from "../ui/idle";

/** Stands in the browser once something else was done. */
const OVER = "kitrobot.begun";
/** A page waits at most so long for its first mission before it is drawn without it, in ms. */
const BLANK_MS = 4000;

function rememberOver(): void {
  // Early work is on the first mission: until Python has it, that one comes back.
  if (!hasEarlyWork()) writeStored(OVER, "yes");
}

/** Whether the page will begin with that mission, as far as can be known without Python. */
function willBeFirst(): boolean {
  const { hash, search } = window.location;
  return pageRole === "" && hash === "" && !new URLSearchParams(search).has("open") && readStored(OVER) === null;
}

/** Draws it, unless the page begins with another one, or Python was there earlier; whether it did. */
export async function drawFirst(base: string): Promise<boolean> {
  if (!willBeFirst()) {
    rememberOver();
    return false;
  }
  let path: string | null = null;
  const end = useStudio.subscribe(({ change, file, dirty }, before) => {
    const same = change.kind === "open" && !dirty && (path === null || file.path === path);
    if (change === before.change || same || useDocument.getState().ahead) return;
    rememberOver();
    end();
  });
  const address = new URL(`first/${languageInUse()}.json`, base);
  // The page is blank until then.
  const response = await fetch(address, { signal: AbortSignal.timeout(BLANK_MS) }).catch(() => null);
  if (!response?.ok) return false;
  const file = (await response.json()) as MissionFile;
  path = file.path;
  drawAhead(file, earlyWorkOn(file)?.history);
  keepEarlyWork(rememberOver);
  return true;
}

/** Resolves when the page has drawn the first mission, which needs the processor alone, or at once if there is none to draw. */
export async function untilDrawn(first: Promise<boolean>): Promise<void> {
  if (!(await first)) return;
  await new Promise<void>(whenIdle);
}
