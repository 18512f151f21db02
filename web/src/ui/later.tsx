/**
 * A component that is fetched when it is first drawn, so that it is not part of the first load.
 *
 * Until then nothing is drawn. A failed fetch is reported, and tried again when the component is drawn next.
 */
import { type ComponentType, createElement, type ReactNode, useEffect, useState } from "react";

import { t } from "../i18n/words";

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
