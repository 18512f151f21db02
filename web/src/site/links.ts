/** Missions that come and go in links: the one of the page's address is opened, the open one is copied as a link. */
import { api, ApiError } from "../api/client";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { complain, fileName, question, useDocument } from "../session/document";
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
    // It is in the address once: what is opened is changed and saved like any mission.
    window.history.replaceState(window.history.state, "", window.location.pathname + window.location.search);
    void whenReady().then(() => open(hash));
  };
  look();
  window.addEventListener("hashchange", look);
}

async function open(hash: string): Promise<void> {
  try {
    const { name, bytes } = await missionOf(hash);
    openFromComputer(new File([bytes], name));
  } catch (cause) {
    complain(told(cause));
  }
}

/** Once the first mission is there. */
function whenReady(): Promise<void> {
  return new Promise((resolve) => {
    if (useDocument.getState().ready) resolve();
    const end = useDocument.subscribe(({ ready }) => {
      if (!ready) return;
      end();
      resolve();
    });
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
    complain(told(cause));
  }
}

export const links: Feature = {
  name: "links",
  useMenu: () => ({ download: [menuItem("file-copy-link", t("site.copy-link"), null, copyLink)] }),
};
