/**
 * A component that is fetched when it is first drawn, so that it is not part of the first load.
 *
 * Until then nothing is drawn. A failed fetch is reported, and tried again when the component is drawn next.
 */
import { type ComponentType, createElement, type ReactNode, useEffect, useRef, useState } from "react";

import { t } from "../i18n/words";

type Fail = (cause: unknown) => void;

/** Keeps what is typed from now on; the returned function gives it to whatever has the focus then, or to nobody. */
function keepTyped(): (give: boolean) => void {
  let typed = "";
  const onKey = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Backspace") typed = typed.slice(0, -1);
    else if (event.key.length === 1) typed += event.key;
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  window.addEventListener("keydown", onKey, true);
  return (give) => {
    window.removeEventListener("keydown", onKey, true);
    // The one way to put text into a field of any kind as if it were typed.
    if (give && typed !== "") document.execCommand("insertText", false, typed);
  };
}

/** `typing`: the part takes the focus into a field; what is typed before it is there is typed into that. */
export function later<Props extends object>(
  load: () => Promise<ComponentType<Props>>,
  fail: Fail,
  typing = false,
): (props: Props) => ReactNode {
  let kept: ComponentType<Props> | null = null;
  return function Later(props: Props) {
    const [part, setPart] = useState(() => kept);
    const held = useRef<((give: boolean) => void) | null>(null);
    useEffect(() => {
      // The effects of the part itself, which take the focus, come before this one.
      if (part === null) return;
      held.current?.(true);
      held.current = null;
    }, [part]);
    useEffect(() => {
      if (kept !== null) return;
      let there = true;
      const release = typing ? keepTyped() : () => undefined;
      held.current = release;
      load().then(
        (loaded) => {
          kept = loaded;
          if (there) setPart(() => loaded);
        },
        () => {
          release(false);
          if (there) fail(new Error(t("error.offline")));
        },
      );
      return () => {
        there = false;
        release(false);
      };
    }, []);
    return part === null ? null : createElement(part, props);
  };
}
