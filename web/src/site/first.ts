/**
 * The mission that a new studio begins with, drawn before Python is there: `kitrobot site` writes the answer that Python will
 * give into the folder. That is true only as long as nothing else was ever done in this browser.
 */
import { pageRole } from "../api/token";
import { languageInUse } from "../i18n/words";
import { useStudio } from "../model/studio";
import type { MissionFile } from "../model/types";
import { drawAhead } from "../session/opening";
import { readStored, writeStored } from "../ui/stored";

/** Stands in the browser once something else was done. */
const OVER = "kitrobot.begun";

function rememberOver(): void {
  writeStored(OVER, "yes");
}

/** Whether the page will begin with that mission, as far as can be known without Python. */
function willBeFirst(): boolean {
  const { hash, search } = window.location;
  return pageRole === "" && hash === "" && !new URLSearchParams(search).has("open") && readStored(OVER) === null;
}

/** Draws it, unless the page begins with another one, or Python was there earlier. */
export async function drawFirst(base: string): Promise<void> {
  if (!willBeFirst()) {
    rememberOver();
    return;
  }
  let path: string | null = null;
  const end = useStudio.subscribe(({ change, file, dirty }, before) => {
    if (change === before.change || (change.kind === "open" && !dirty && (path === null || file.path === path))) return;
    rememberOver();
    end();
  });
  const response = await fetch(new URL(`first/${languageInUse()}.json`, base)).catch(() => null);
  if (!response?.ok) return;
  const file = (await response.json()) as MissionFile;
  path = file.path;
  drawAhead(file);
}
