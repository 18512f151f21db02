/** A finger that rests asks for the menu, as the right button does. */
import { endAll, listen } from "./effects";

const REST_MS = 550;
const STILL_PX = 8;

/** From a pointer that went down: calls back where a finger stays for a while without moving; a mouse never does. */
export function onLongPress(
  { pointerType, clientX: x, clientY: y }: Pick<PointerEvent, "pointerType" | "clientX" | "clientY">,
  open: (x: number, y: number) => void,
): () => void {
  if (pointerType === "mouse") return () => undefined;
  const timer = setTimeout(() => {
    end();
    open(x, y);
  }, REST_MS);
  const moved = (move: PointerEvent) => {
    if (Math.hypot(move.clientX - x, move.clientY - y) > STILL_PX) end();
  };
  const end = endAll(
    () => clearTimeout(timer),
    listen(window, { pointermove: moved, pointerup: () => end(), pointercancel: () => end() }, { capture: true }),
  );
  return end;
}
