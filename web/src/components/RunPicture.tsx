/**
 * What a mission does, as a small picture that moves while it is seen: the first seconds of a run, over and over, drawn as
 * the arena draws them. A mission that cannot run is shown as its graph.
 */
import "./run-picture.css";

import { useEffect, useRef } from "react";

import type { RunPreview } from "../api/generated";
import { useStudio } from "../model/studio";
import { useTheme } from "../theme";
import { keepDrawing } from "./picture-clock";
import { readColours } from "./scene/colours";
import { bestMoment, drawMoment } from "./scene/play";
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
  const canvas = useRef<HTMLCanvasElement>(null);
  const catalogue = useStudio((studio) => studio.catalogue);
  const theme = useTheme((state) => state.theme);
  const moves = plays && preview.frames > 1 && !matchMedia("(prefers-reduced-motion: reduce)").matches;
  useEffect(() => {
    const element = canvas.current;
    const pen = element?.getContext("2d") ?? null;
    if (element === null || pen === null) return;
    const drawn = { preview, world, catalogue, colours: readColours(), dark: theme === "dark" };
    let began = performance.now();
    let moment = bestMoment(preview);
    const draw = () => {
      const [width, height] = [element.clientWidth, element.clientHeight];
      if (width === 0 || height === 0) return;
      const ratio = window.devicePixelRatio || 1;
      const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
      if (element.width !== wide) element.width = wide;
      if (element.height !== high) element.height = high;
      pen.setTransform(ratio, 0, 0, ratio, 0, 0);
      drawMoment(pen, { width, height }, drawn, moment);
    };
    let end: (() => void) | null = null;
    const go = (seen: boolean) => {
      element.dataset["moves"] = String(seen && moves);
      end?.();
      end = null;
      if (!seen || !moves) return;
      began = performance.now();
      end = keepDrawing((now) => {
        moment = momentAfter(Math.max(0, now - began), preview.frames);
        draw();
      });
    };
    draw();
    const size = new ResizeObserver(draw);
    size.observe(element);
    const sight = new IntersectionObserver((entries) => {
      go(entries.at(-1)?.isIntersecting === true);
    });
    sight.observe(element);
    return () => {
      size.disconnect();
      sight.disconnect();
      end?.();
    };
  }, [preview, world, catalogue, theme, moves]);
  return <canvas ref={canvas} className="picture picture-run" data-moves="false" aria-hidden="true" />;
}
