/** So long a page that always has something to do is waited for, in ms. */
const MOST_MS = 3000;

/** Does something once the page has nothing else to do. */
export function whenIdle(act: () => void): void {
  // Safari has no such call.
  if ("requestIdleCallback" in window) requestIdleCallback(act, { timeout: MOST_MS });
  else setTimeout(act);
}
