/**
 * A component that is fetched when it is first drawn, so that it is not part of the first load; with it come the words of
 * `i18n/en-later*.ts`.
 *
 * Until then nothing is drawn. A failed fetch is reported, and tried again when the component is drawn next.
 */
import { type ComponentType, createElement, type ReactNode, useEffect, useRef, useState } from "react";

import { moreWords, t } from "../i18n/words";
import { holdKeys } from "./held-keys";

type Fail = (cause: unknown) => void;

interface LaterOptions {
  /** The part takes the focus into a field; keys that are pressed before it is there are pressed in that. */
  typing?: boolean;
  /** False for a part that says nothing which is fetched later: what begins without a mission shows no other. */
  words?: boolean;
}

export function later<Props extends object>(
  load: () => Promise<ComponentType<Props>>,
  fail: Fail,
  { typing = false, words = true }: LaterOptions = {},
): (props: Props) => ReactNode {
  let kept: ComponentType<Props> | null = null;
  let coming: Promise<void> | null = null;
  const fetchOnce = () =>
    (coming ??= Promise.all([load(), words ? moreWords() : null]).then(
      ([loaded]) => {
        kept = loaded;
      },
      (cause: unknown) => {
        coming = null;
        throw cause;
      },
    ));
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
      if (kept !== null) {
        // Another one of these has fetched it since this one was drawn.
        setPart(() => kept);
        return;
      }
      let there = true;
      const release = typing ? holdKeys() : () => undefined;
      held.current = release;
      fetchOnce().then(
        () => {
          if (there) setPart(() => kept);
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
