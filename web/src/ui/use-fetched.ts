/** What is asked for when something is drawn, and forgotten with it. */
import { useEffect, useRef, useState } from "react";

/**
 * What `ask` gives; null while it is on its way. Another `ask` asks again, and what came before is gone at once.
 *
 * `fail` is told why nothing came, and says what there is instead.
 */
export function useFetched<T>(ask: () => Promise<T>, fail: (cause: unknown) => T | null): T | null {
  const [found, setFound] = useState<{ of: () => Promise<T>; value: T | null } | null>(null);
  const failed = useRef(fail);
  useEffect(() => {
    failed.current = fail;
  });
  useEffect(() => {
    let there = true;
    ask().then(
      (value) => {
        if (there) setFound({ of: ask, value });
      },
      (cause: unknown) => {
        if (there) setFound({ of: ask, value: failed.current(cause) });
      },
    );
    return () => {
      there = false;
    };
  }, [ask]);
  return found?.of === ask ? found.value : null;
}
