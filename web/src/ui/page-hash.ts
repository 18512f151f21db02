/** The part of the page's address behind its `#`: what a link brings along. */
import { listen } from "./effects";

/** Looks at it now and whenever it changes; the returned function ends that. */
export function watchHash(look: (hash: string) => void): () => void {
  look(window.location.hash);
  return listen(window, { hashchange: () => look(window.location.hash) });
}

/** It was followed: loading the page again does not follow it again. */
export function forgetHash(): void {
  window.history.replaceState(window.history.state, "", window.location.pathname + window.location.search);
}
