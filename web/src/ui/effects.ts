/** What effects do again and again: each function returns the cleanup of its effect. */
/** Ends several things that go on, as one. */
export function endAll(...ends: readonly (() => void)[]): () => void {
  return () => ends.forEach((end) => end());
}

type Events = WindowEventMap & DocumentEventMap;

/** Listens to events of one target. */
export function listen(
  target: EventTarget,
  listeners: { [Name in keyof Events]?: (event: Events[Name]) => void },
  options: AddEventListenerOptions = {},
): () => void {
  const all = Object.entries(listeners) as [string, EventListener][];
  for (const [name, listener] of all) target.addEventListener(name, listener, options);
  return () => {
    for (const [name, listener] of all) target.removeEventListener(name, listener, options);
  };
}

/** Calls back with what comes of a request, unless it is ended before; who is told no failure lets it pass. */
export function awaitAnswer<T>(
  answer: Promise<T>,
  take: (value: T) => void,
  fail: (cause: unknown) => void = () => undefined,
): () => void {
  let over = false;
  answer.then(
    (value) => {
      if (!over) take(value);
    },
    (cause: unknown) => {
      if (!over) fail(cause);
    },
  );
  return () => {
    over = true;
  };
}

/** Begins after a pause; what is begun may return its own end. */
export function afterPause(pause_ms: number, begin: () => (() => void) | void): () => void {
  let end: (() => void) | void;
  const timer = setTimeout(() => {
    end = begin();
  }, pause_ms);
  return () => {
    clearTimeout(timer);
    end?.();
  };
}
