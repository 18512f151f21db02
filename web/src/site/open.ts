/**
 * Begins a static site: one tab of the browser has the studio, with Python in a worker of it.
 *
 * A second tab waits until the first is closed (`alone`). The files of the site are kept by its service worker once Python is
 * there, so that they are fetched once.
 */
import { createElement } from "react";
import { createRoot } from "react-dom/client";

import { PARTS, type Parts, siteParts } from "../api/site-parts";
import { pageRole, pupilName } from "../api/token";
import { setTransport } from "../api/transport";
import { moreWords } from "../i18n/words";
import { features, install } from "../session/features";
import { flush, setKept } from "../session/journal";
import { alone } from "./alone";
import { drawFirst, untilDrawn } from "./first";
import { links, openLinked } from "./links";
import { forgetMemory } from "./memory";
import type { FromWorker, ToWorker } from "./messages";
import { SiteStrip } from "./SiteStrip";
import { setSite } from "./state";
import { WorkerLine } from "./worker-line";

/**
 * Begins it; `spoken` resolves once there are words. What is asked of the studio meanwhile waits. Resolves when the page may be
 * drawn: with its first mission, if that comes before Python.
 */
export function openSite(spoken: Promise<unknown>): Promise<unknown> {
  const base = new URL(".", document.baseURI).href;
  const path = new URL(base).pathname;
  let give: (worker: Worker) => void = () => undefined;
  const worker = new Promise<Worker>((resolve) => {
    give = resolve;
  });
  const line = new WorkerLine((message, transfer) => {
    void worker.then((there) => there.postMessage(message, transfer ?? []));
  }, path);
  setTransport(line);
  // A link brings a mission; in a class the teacher says which one is open.
  if (pageRole === "") install([...features(), links]);
  const begin = () => {
    draw();
    if (pageRole === "") openLinked();
  };
  // Without these words the page still says most.
  void spoken.then(moreWords).then(begin, begin);
  return new Promise((resolve) => {
    alone(`kitrobot ${path}`, {
      begin: () => {
        setSite({ phase: "fetching" });
        const first = spoken.then(() => drawFirst(base)).catch(() => false);
        resolve(first);
        void untilDrawn(first)
          .then(() => begun(line, base, give))
          .catch((cause: unknown) => broke(base, String(cause)));
      },
      wait: () => {
        setSite({ phase: "other-tab" });
        resolve(false);
      },
    });
  });
}

function draw(): void {
  const place = document.createElement("div");
  document.body.append(place);
  createRoot(place).render(createElement(SiteStrip));
}

/** `give` takes the worker once it knows what it begins with: nothing may come before that. */
function begun(line: WorkerLine, base: string, give: (worker: Worker) => void): void {
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  worker.addEventListener("message", ({ data }: MessageEvent<FromWorker>) => {
    if (!line.hear(data)) follow(base, data);
  });
  worker.addEventListener("error", (event) => broke(base, event.message || ""));
  const unpacker = new Worker(new URL("./unpacker.ts", import.meta.url), { type: "module" });
  unpacker.addEventListener("error", (event) => broke(base, event.message || ""));
  const { port1, port2 } = new MessageChannel();
  unpacker.postMessage(port1, [port1]);
  const first = (parts: Parts): ToWorker => ({ kind: "begin", base, parts, unpacker: port2, pupil: pupilName() });
  siteParts().then(
    (parts) => {
      worker.postMessage(first(parts), [port2]);
      give(worker);
    },
    () => setSite({ phase: "unfetched", reason: PARTS }),
  );
}

/** The next try begins with nothing that was kept of this one. */
function broke(base: string, reason: string): void {
  void forgetMemory(base);
  setSite({ phase: "broken", reason });
}

function follow(base: string, message: FromWorker): void {
  switch (message.kind) {
    case "progress":
      setSite({ fetched: message.fetched / message.total });
      break;
    case "starting":
      setSite({ phase: "starting" });
      break;
    case "ready":
      setSite({ phase: "ready" });
      // Whether the browser promises to keep it or not, the page works.
      navigator.storage?.persist?.().catch(() => undefined);
      void keepFiles(base);
      break;
    case "broken":
      if (message.unfetched) setSite({ phase: "unfetched", reason: message.reason });
      else broke(base, message.reason);
      break;
    case "keeping":
      setSite({ keeping: message.keeping });
      setKept(message.keeping === "kept");
      break;
    default:
      break;
  }
}

/** Has the service worker keep the files of the site, and says when there are newer ones. */
async function keepFiles(base: string): Promise<void> {
  if (!("serviceWorker" in navigator)) {
    await fetchPage(base).catch(() => undefined);
    return;
  }
  try {
    const registered = await navigator.serviceWorker.register("service-worker.js");
    const look = (found: ServiceWorker | null) => {
      const offer = () => {
        // The first one is no news.
        if (found?.state === "installed" && navigator.serviceWorker.controller !== null) offerNew(found);
      };
      offer();
      found?.addEventListener("statechange", offer);
    };
    look(registered.waiting);
    registered.addEventListener("updatefound", () => look(registered.installing));
  } catch {
    // Without it the page works as long as there is a network.
  }
}

/**
 * Fetches the parts of the page that were not needed yet, so that the browser has them while the server is away: pages that
 * came over `http://` from another machine have no service worker.
 */
async function fetchPage(base: string): Promise<void> {
  const { page } = await siteParts();
  for (const name of page) await (await fetch(new URL(name, base), { priority: "low" })).arrayBuffer();
}

function offerNew(found: ServiceWorker): void {
  setSite({
    renew: () => {
      setSite({ renewing: true });
      navigator.serviceWorker.addEventListener("controllerchange", () => window.location.reload());
      void flush().finally(() => found.postMessage("take over"));
    },
  });
}
