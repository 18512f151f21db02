/**
 * Keys that are pressed while a field is still being fetched, and text that is pasted: kept in their order, then done in the
 * field.
 *
 * The listener stands on the window before any other, so that a key that is kept does nothing else until then.
 */

/** Characters, and what is done with them; other keys (Tab, F5) go on meaning what they do. */
const KEPT = /^(.|Backspace|Enter|Escape|Arrow[A-Z][a-z]+)$/u;

/** A key, or text that was pasted. */
type KeyOrText = KeyboardEvent | string;

/** Nothing is kept while there is no holder; the last one gets the keys. */
const holders: KeyOrText[][] = [];

function isEditable(element: Element | null): element is HTMLElement {
  return element instanceof HTMLElement && element.closest("input, textarea, [contenteditable=true]") !== null;
}

/** Text goes into a field as if it were typed; any other key, or a key for something else, is an event of its own. */
function press(event: KeyOrText): void {
  const { activeElement } = document;
  if (typeof event === "string") document.execCommand("insertText", false, event);
  else if (isEditable(activeElement) && event.key.length === 1) document.execCommand("insertText", false, event.key);
  else if (isEditable(activeElement) && event.key === "Backspace") document.execCommand("delete");
  else (activeElement ?? document.body).dispatchEvent(new KeyboardEvent(event.type, event));
}

if (typeof window !== "undefined") {
  window.addEventListener(
    "keydown",
    (event) => {
      const keys = holders.at(-1);
      // What dispatches here has been kept before.
      if (keys === undefined || !event.isTrusted || event.isComposing || !KEPT.test(event.key)) return;
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      keys.push(event);
      event.preventDefault();
      event.stopImmediatePropagation();
    },
    true,
  );
  window.addEventListener(
    "paste",
    (event) => {
      const text = event.clipboardData?.getData("text/plain") ?? "";
      const keys = holders.at(-1);
      if (keys === undefined || text === "") return;
      keys.push(text);
      event.preventDefault();
      event.stopImmediatePropagation();
    },
    true,
  );
}

/** Keeps keys from now on; the returned function presses them where the focus is then, or forgets them. */
export function holdKeys(): (give: boolean) => void {
  const keys: KeyOrText[] = [];
  let isGiven = false;
  holders.push(keys);
  const end = () => {
    const at = holders.indexOf(keys);
    if (at >= 0) holders.splice(at, 1);
  };
  /** One key for each task, so that what it changed is drawn before the next; keys pressed meanwhile come behind. */
  const next = () => {
    const key = keys.shift();
    if (key === undefined) end();
    else {
      press(key);
      setTimeout(next);
    }
  };
  return (give) => {
    if (isGiven) return;
    isGiven = true;
    if (give) setTimeout(next);
    else end();
  };
}
