/**
 * A part of the page that is fetched when it is first wanted, so that the first load need not carry it.
 *
 * Until it is there nothing stands in its place; where it cannot be fetched the person is told, and the next time tries again.
 */
import { type ComponentType, createElement, type ReactNode, useEffect, useState } from "react";

import { t } from "../words/words";

type Fail = (cause: unknown) => void;

export function later<Props extends object>(
  load: () => Promise<ComponentType<Props>>,
  fail: Fail,
): (props: Props) => ReactNode {
  let kept: ComponentType<Props> | null = null;
  return function Later(props: Props) {
    const [part, setPart] = useState(() => kept);
    useEffect(() => {
      if (kept !== null) return;
      let there = true;
      load().then(
        (loaded) => {
          kept = loaded;
          if (there) setPart(() => loaded);
        },
        () => {
          if (there) fail(new Error(t("error.offline")));
        },
      );
      return () => {
        there = false;
      };
    }, []);
    return part === null ? null : createElement(part, props);
  };
}
