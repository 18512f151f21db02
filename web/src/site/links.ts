/** Missions that come and go in links: the one of the page's address is opened, the open one is copied as a link. */
import { api, ApiError } from "../api/client";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { pageRole } from "../api/token";
import { fileName, note, reportError, whenReady } from "../session/document";
import { addressOfExercise } from "../session/exercise-link";
import type { Feature } from "../session/features";
import { setHandIn, useOpenExercise, workPlace } from "../session/open-exercise";
import { openFromComputer } from "../session/open-requests";
import { downloadMission } from "../session/saving";
import { copyText } from "../ui/copy-text";
import { type MenuEntry, menuItem } from "../ui/menu-model";
import { forgetHash, watchHash } from "../ui/page-hash";
import { holdsMission, LinkError, linkTo, missionOf } from "./mission-link";

function told(cause: unknown): unknown {
  return cause instanceof LinkError ? new ApiError(t(cause.fault), t("site.link-help")) : cause;
}

/** Opens the mission of the address, now and whenever the address changes. */
export function openLinked(): void {
  watchHash((hash) => {
    if (holdsMission(hash)) void whenReady().then(() => open(hash));
  });
}

async function open(hash: string): Promise<void> {
  try {
    const { name, bytes } = await missionOf(hash);
    forgetOnceChanged(name);
    openFromComputer(new File([bytes], name));
  } catch (cause) {
    forgetHash();
    reportError(told(cause));
  }
}

/** Loading the page again opens the link again, until the mission was changed: then the journal has it. */
function forgetOnceChanged(name: string): void {
  let there = false;
  const end = useStudio.subscribe(({ dirty, file }) => {
    const ours = file.path === "" && file.name === name;
    if (!there && ours && !dirty) there = true;
    else if (there && (dirty || !ours)) {
      end();
      forgetHash();
    }
  });
}

async function copyLink(): Promise<void> {
  try {
    const { text } = await api.missionText(useStudio.getState().mission);
    const address = new URL(window.location.href);
    address.hash = await linkTo(text, fileName());
    await give(address.href, t("site.link-copied-help"));
  } catch (cause) {
    reportError(told(cause));
  }
}

/** Puts a link on the clipboard, or into the address bar. */
async function give(address: string, help: string): Promise<void> {
  const copied = await copyText(address);
  if (!copied) window.history.replaceState(window.history.state, "", address);
  note(t(copied ? "site.link-copied" : "site.link-shown"), help);
}

/** On a site there is no class: what is handed in is a file. */
async function handIn(): Promise<void> {
  if (await downloadMission()) note(t("site.handed-in", { name: fileName() }), t("site.handed-in-help"));
}

/** A link to the exercise that is worked on; those of the folder are in this browser only. */
function useExerciseEntries(): MenuEntry[] {
  const open = useOpenExercise((state) => state.open);
  const place = useStudio(({ file }) => workPlace(file));
  const name = open?.path === place ? open.name : "";
  if (pageRole !== "" || !name.startsWith("example:")) return [];
  const copy = () => give(addressOfExercise(window.location.href, name), t("site.exercise-link-help"));
  return [menuItem("file-copy-exercise-link", t("site.copy-exercise-link"), null, copy)];
}

export const links: Feature = {
  name: "links",
  useMenu: () => {
    const exercise = useExerciseEntries();
    return { download: [menuItem("file-copy-link", t("site.copy-link"), null, copyLink), ...exercise] };
  },
  start: () => {
    // In a class it is handed in there.
    if (pageRole !== "") return () => undefined;
    setHandIn(() => void handIn());
    return () => setHandIn(null);
  },
};
