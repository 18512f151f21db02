/** Missions that come and go in links: the one of the page's address is opened, the open one is copied as a link. */
import { api, ApiError } from "../api/client";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { fileName, question, reportError, whenReady } from "../session/document";
import type { Feature } from "../session/features";
import { openFromComputer } from "../session/open-requests";
import { menuItem } from "../ui/menu-model";
import { holdsMission, LinkError, linkTo, missionOf } from "./mission-link";

function told(cause: unknown): unknown {
  return cause instanceof LinkError ? new ApiError(t(cause.fault), t("site.link-help")) : cause;
}

/** Opens the mission of the address, now and whenever the address changes. */
export function openLinked(): void {
  const look = () => {
    const { hash } = window.location;
    if (!holdsMission(hash)) return;
    void whenReady().then(() => open(hash));
  };
  look();
  window.addEventListener("hashchange", look);
}

async function open(hash: string): Promise<void> {
  try {
    const { name, bytes } = await missionOf(hash);
    forgetOnceChanged(name);
    openFromComputer(new File([bytes], name));
  } catch (cause) {
    forget();
    reportError(told(cause));
  }
}

function forget(): void {
  window.history.replaceState(window.history.state, "", window.location.pathname + window.location.search);
}

/** Loading the page again opens the link again, until the mission was changed: then the journal has it. */
function forgetOnceChanged(name: string): void {
  let there = false;
  const end = useStudio.subscribe(({ dirty, file }) => {
    const ours = file.path === "" && file.name === name;
    if (!there && ours && !dirty) there = true;
    else if (there && (dirty || !ours)) {
      end();
      forget();
    }
  });
}

async function copyLink(): Promise<void> {
  try {
    const { text } = await api.missionText(useStudio.getState().mission);
    const address = new URL(window.location.href);
    address.hash = await linkTo(text, fileName());
    try {
      await navigator.clipboard.writeText(address.href);
      question(t("site.link-copied"), [], "note", t("site.link-copied-help"));
    } catch {
      window.history.replaceState(window.history.state, "", address);
      question(t("site.link-shown"), [], "note", t("site.link-copied-help"));
    }
  } catch (cause) {
    reportError(told(cause));
  }
}

export const links: Feature = {
  name: "links",
  useMenu: () => ({ download: [menuItem("file-copy-link", t("site.copy-link"), null, copyLink)] }),
};
