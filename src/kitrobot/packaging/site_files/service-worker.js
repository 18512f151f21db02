/*
 * Keeps the files of a static site, so that it works without a network. `kitrobot site` writes the two lines below.
 *
 * All files of a version are kept together: a page never gets some of one and some of another. A new version is fetched
 * whole, and takes over when the page says so or when no page of the old one is open any more.
 */
const VERSION = "@VERSION@";
const FILES = ["@FILES@"];

const OURS = `kitrobot ${self.registration.scope} `;
const KEPT = OURS + VERSION;

self.addEventListener("install", (event) => {
  const wanted = FILES.map((name) => new Request(name, { cache: "no-cache" }));
  event.waitUntil(caches.open(KEPT).then((kept) => kept.addAll(wanted)));
});

async function forgetOthers() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(OURS) && name !== KEPT).map((name) => caches.delete(name)));
  await self.clients.claim();
}

self.addEventListener("activate", (event) => event.waitUntil(forgetOthers()));

self.addEventListener("message", ({ data }) => {
  if (data === "take over") void self.skipWaiting();
});

async function kept(request, name) {
  const cache = await caches.open(KEPT);
  return (await cache.match(new URL(name, self.registration.scope))) ?? fetch(request);
}

self.addEventListener("fetch", (event) => {
  const { method, url } = event.request;
  const scope = self.registration.scope;
  if (method !== "GET" || !url.startsWith(scope)) return;
  const name = url.slice(scope.length).replace(/[?#].*$/u, "") || "index.html";
  if (FILES.includes(name)) event.respondWith(kept(event.request, name));
});
