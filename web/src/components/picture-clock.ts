/** One clock for all pictures that move: it runs while there is one that is seen, and calls each a few times a second. */

/** Between two drawings, in ms: a small picture needs no more. */
const APART_MS = 40;

type Draw = (now: number) => void;

const drawn = new Set<Draw>();
let frame = 0;
let last = 0;

function run(now: number): void {
  frame = requestAnimationFrame(run);
  if (now - last < APART_MS) return;
  last = now;
  for (const draw of drawn) draw(now);
}

/** Calls `draw` from now on; the returned function ends it. */
export function keepDrawing(draw: Draw): () => void {
  drawn.add(draw);
  if (frame === 0) {
    last = 0;
    frame = requestAnimationFrame(run);
  }
  return () => {
    drawn.delete(draw);
    if (drawn.size > 0) return;
    cancelAnimationFrame(frame);
    frame = 0;
  };
}

/** Whether the person at this page wants less motion. */
export function wantsLessMotion(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}

/** How many pictures move now. */
export function movingPictures(): number {
  return drawn.size;
}
