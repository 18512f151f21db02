/** Elements that are drawn a moment later, perhaps after a chunk of the page has come. */

/** Does something with an element once it is there; gives up when the person presses a key or a button before. */
export function whenThere(selector: string, act: (element: HTMLElement) => void): void {
  const acted = (): boolean => {
    const found = document.querySelector<HTMLElement>(selector);
    if (found !== null) act(found);
    return found !== null;
  };
  if (acted()) return;
  const ended = new AbortController();
  const observer = new MutationObserver(() => {
    if (acted()) ended.abort();
  });
  ended.signal.addEventListener("abort", () => {
    observer.disconnect();
  });
  observer.observe(document.body, { childList: true, subtree: true });
  for (const kind of ["keydown", "pointerdown"] as const) {
    document.addEventListener(kind, () => ended.abort(), { capture: true, signal: ended.signal });
  }
}
