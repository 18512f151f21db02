/** Changes after which an element must be measured again: of its size, of what holds it, of its content, of the fonts. */

/**
 * Calls `again` now and after each of them; the returned function ends it. `attributeFilter`: attributes in it that count
 * as content. Without a layout (tests) nothing is called.
 */
export function watchLayout(element: HTMLElement, again: () => void, attributeFilter?: string[]): () => void {
  if (typeof ResizeObserver === "undefined") return () => undefined;
  const size = new ResizeObserver(again);
  size.observe(element);
  // Its own size says nothing while it is as wide as its parts want.
  if (element.parentElement !== null) size.observe(element.parentElement);
  const content = new MutationObserver(again);
  const attributes = attributeFilter === undefined ? {} : { attributeFilter };
  content.observe(element, { childList: true, characterData: true, subtree: true, ...attributes });
  document.fonts.addEventListener("loadingdone", again);
  again();
  return () => {
    document.fonts.removeEventListener("loadingdone", again);
    size.disconnect();
    content.disconnect();
  };
}
