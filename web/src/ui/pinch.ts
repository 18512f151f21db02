/** Two fingers on an element: how far they are apart and what lies between them. One finger is not its matter. */
import { listen } from "./effects";

export interface Spread {
  x: number;
  y: number;
  far: number;
}

interface PinchHandlers {
  /** Two fingers are down: what one finger began has to end. false: they mean something else. */
  begin: () => boolean;
  /** They moved; places in px from the corner of the element. */
  move: (before: Spread, now: Spread) => void;
}

/** Watches the fingers on an element; gives what ends it. */
export function watchPinch(element: HTMLElement, { begin, move }: PinchHandlers): () => void {
  let before: Spread | null = null;
  const spread = ({ touches }: TouchEvent): Spread | null => {
    const [a, b, third] = [...touches].filter(({ target }) => element.contains(target as Node));
    if (a === undefined || b === undefined || third !== undefined) return null;
    const { left, top } = element.getBoundingClientRect();
    const far = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
    return { x: (a.clientX + b.clientX) / 2 - left, y: (a.clientY + b.clientY) / 2 - top, far: Math.max(1, far) };
  };
  const taken = (event: TouchEvent) => {
    event.preventDefault();
    event.stopPropagation();
  };
  const onStart = (event: TouchEvent) => {
    before = spread(event);
    if (before === null) return;
    if (begin()) taken(event);
    else before = null;
  };
  const onMove = (event: TouchEvent) => {
    const now = spread(event);
    if (before === null || now === null) return;
    taken(event);
    move(before, now);
    before = now;
  };
  const onEnd = () => {
    before = null;
  };
  const listeners = { touchstart: onStart, touchmove: onMove, touchend: onEnd, touchcancel: onEnd };
  return listen(element, listeners, { capture: true, passive: false });
}
