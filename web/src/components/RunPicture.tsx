/**
 * What a mission does, as a small picture that moves while it is seen: the first seconds of a run, over and over, drawn as
 * the arena draws them. A mission that cannot run is shown as its graph.
 */
import "./run-picture.css";

import { useEffect } from "react";

import type { RunPreview } from "../api/generated";
import { keepDrawing, wantsLessMotion } from "./picture-clock";
import { useRunCanvas } from "./run-canvas";
import { bestMoment } from "./scene/play";
import { GraphPicture } from "./WorldPicture";

/** Frames a second. */
const PACE = 10;
/** How long the end is shown before it begins again, in seconds. */
const REST_S = 1.2;

/** The moment of a preview that is shown after so many ms. */
export function momentAfter(ms: number, frames: number): number {
  if (frames < 2) return 0;
  const whole = (frames - 1) / PACE + REST_S;
  return Math.min(frames - 1, ((ms / 1000) % whole) * PACE);
}

interface RunPictureProps {
  preview: RunPreview;
  /** Whether it moves while it is seen; a person who wants less motion sees it stand. */
  plays: boolean;
}

export function RunPicture({ preview, plays }: RunPictureProps) {
  if (preview.world === null || preview.frames === 0)
    return preview.program === null ? null : <GraphPicture program={preview.program} />;
  return <Played preview={preview} world={preview.world} plays={plays} />;
}

function Played({ preview, world, plays }: RunPictureProps & { world: NonNullable<RunPreview["world"]> }) {
  const [canvas, draw] = useRunCanvas({ preview, world });
  const moves = plays && preview.frames > 1 && !wantsLessMotion();
  useEffect(() => {
    const element = canvas.current;
    if (element === null) return;
    let end: (() => void) | null = null;
    const go = (seen: boolean) => {
      element.dataset["moves"] = String(seen && moves);
      end?.();
      end = null;
      if (!seen || !moves) return;
      const began = performance.now();
      end = keepDrawing((now) => draw(momentAfter(Math.max(0, now - began), preview.frames)));
    };
    draw(bestMoment(preview));
    const sight = new IntersectionObserver((entries) => {
      go(entries.at(-1)?.isIntersecting === true);
    });
    sight.observe(element);
    return () => {
      sight.disconnect();
      end?.();
    };
  }, [canvas, draw, preview, moves]);
  return <canvas ref={canvas} className="picture picture-run" data-moves="false" aria-hidden="true" />;
}
