/**
 * The ground that the graph lies on, and how a hand moves it: a drag pans, a wheel zooms at the pointer, and so do two fingers
 * on a trackpad. What is pressed itself (vertices, buttons) pans with the middle button only.
 */
import { type PointerEvent, type ReactNode, useEffect, useLayoutEffect, useRef } from "react";

import { restFollowing } from "../../session/view";
import { endAll, listen } from "../../ui/effects";
import { type Camera, useCamera, zoomed } from "./camera";
import { MOST_ZOOM } from "./zoom-range";

const PRESSED = ".canvas-node, .teaching, .fold";
const DOTS = 16;
/** A hand that clicks is not quite still. */
const STILL_PX = 1;

/** How many times larger a turn of the wheel makes the graph; two fingers that pinch a Mac's trackpad turn it a little. */
export function wheelFactor({ deltaY, deltaMode, ctrlKey }: WheelEvent): number {
  const unit = deltaMode === WheelEvent.DOM_DELTA_LINE ? 0.05 : deltaMode === WheelEvent.DOM_DELTA_PAGE ? 1 : 0.002;
  return 2 ** (-deltaY * unit * (ctrlKey && navigator.userAgent.includes("Mac") ? 10 : 1));
}

/** `least`: how small the graph may become; `dots`: whether the ground has them; `onPress`: a click beside everything. */
export function Pane(props: { least: number; dots: boolean; onPress: () => void; children: ReactNode }) {
  const { least, dots, onPress, children } = props;
  const camera = useCamera();
  const pane = useRef<HTMLDivElement>(null);
  const graph = useRef<HTMLDivElement>(null);
  /** Ends the pan that is on. */
  const end = useRef<(() => void) | null>(null);
  /** Whether the last press became one. */
  const panned = useRef(false);

  useLayoutEffect(() => {
    const show = ({ x, y, zoom }: Camera) => {
      if (graph.current === null || pane.current === null) return;
      graph.current.style.transform = `translate(${String(x)}px, ${String(y)}px) scale(${String(zoom)})`;
      const { style } = pane.current;
      style.backgroundPosition = `${String(x)}px ${String(y)}px`;
      style.backgroundSize = `${String(DOTS * zoom)}px ${String(DOTS * zoom)}px`;
    };
    show(camera.now());
    return camera.store.subscribe(show);
  }, [camera]);

  useEffect(() => {
    const ground = pane.current;
    if (ground === null) return;
    const turn = (event: WheelEvent) => {
      event.preventDefault();
      restFollowing();
      const { left, top } = ground.getBoundingClientRect();
      const { zoom } = camera.now();
      const next = Math.min(MOST_ZOOM, Math.max(least, zoom * wheelFactor(event)));
      camera.jump(zoomed(camera.now(), next, { x: event.clientX - left, y: event.clientY - top }));
    };
    return listen(ground, { wheel: turn }, { passive: false });
  }, [camera, least]);

  useEffect(() => () => end.current?.(), []);

  const begin = (event: PointerEvent) => {
    const ground = pane.current;
    panned.current = false;
    if (ground === null || !event.isPrimary || event.button > 1 || event.ctrlKey) return;
    const { target } = event;
    if (event.button === 0 && target instanceof Element && target.closest(PRESSED) !== null) return;
    // Shift draws a box there.
    if (event.shiftKey && target === ground) return;
    const { pointerId } = event;
    let at = { x: event.clientX, y: event.clientY };
    const move = (next: globalThis.PointerEvent) => {
      if (next.pointerId !== pointerId) return;
      const [dx, dy] = [next.clientX - at.x, next.clientY - at.y];
      if (!panned.current) {
        if (Math.hypot(dx, dy) <= STILL_PX) return;
        panned.current = true;
        // From now on the click at the end is the ground's.
        ground.setPointerCapture(pointerId);
        ground.dataset["moving"] = "";
      }
      at = { x: next.clientX, y: next.clientY };
      restFollowing();
      camera.pan(dx, dy);
    };
    const lift = (next: globalThis.PointerEvent) => {
      if (next.pointerId === pointerId) finish();
    };
    const finish = () => {
      endListening();
      delete ground.dataset["moving"];
      end.current = null;
    };
    end.current = finish;
    const endListening = endAll(
      listen(window, { pointermove: move, pointerup: lift, pointercancel: lift }),
      // A second finger zooms, which ends what the first one began.
      listen(window, { pointerdown: finish }, { capture: true }),
    );
  };

  return (
    <div
      ref={pane}
      className="canvas-pane"
      data-dots={dots}
      onPointerDown={begin}
      onClick={(event) => {
        if (event.target === event.currentTarget && !panned.current) onPress();
      }}
    >
      <div ref={graph} className="canvas-graph passive">
        {children}
      </div>
    </div>
  );
}
