/** A canvas on which a preview of a run is drawn at any moment, as large as it is and in the colours of the theme. */
import { type RefObject, useCallback, useEffect, useMemo, useRef } from "react";

import type { RunPreview } from "../api/generated";
import { useStudio } from "../model/studio";
import type { World } from "../model/types";
import { useTheme } from "../theme";
import type { Box } from "./scene/camera";
import { type Colours, readColours } from "./scene/colours";
import { boxOf, drawMoment } from "./scene/play";

export interface Shown {
  preview: RunPreview;
  world: World;
  /** What of the world is seen; what is driven, unless told. */
  box?: Box | undefined;
  /** Whether robots have their names beside them. */
  names?: boolean;
}

/** The canvas, and what draws a moment on it. */
export function useRunCanvas({
  preview,
  world,
  box,
  names = false,
}: Shown): [RefObject<HTMLCanvasElement | null>, (moment: number) => void] {
  const canvas = useRef<HTMLCanvasElement>(null);
  const colours = useRef<Colours | null>(null);
  const shown = useRef(0);
  const catalogue = useStudio((studio) => studio.catalogue);
  const theme = useTheme((state) => state.theme);
  const drawn = useMemo(
    () => ({ preview, world, catalogue, box: box ?? boxOf(world, preview), names, dark: theme === "dark" }),
    [preview, world, catalogue, box, names, theme],
  );
  const draw = useCallback(
    (moment: number) => {
      shown.current = moment;
      const element = canvas.current;
      const pen = element?.getContext("2d") ?? null;
      if (element === null || pen === null || colours.current === null) return;
      const [width, height] = [element.clientWidth, element.clientHeight];
      if (width === 0 || height === 0) return;
      const ratio = window.devicePixelRatio || 1;
      const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
      if (element.width !== wide) element.width = wide;
      if (element.height !== high) element.height = high;
      pen.setTransform(ratio, 0, 0, ratio, 0, 0);
      drawMoment(pen, { width, height }, { ...drawn, colours: colours.current }, moment);
    },
    [drawn],
  );
  useEffect(() => {
    const element = canvas.current;
    if (element === null) return;
    colours.current = readColours();
    draw(shown.current);
    const size = new ResizeObserver(() => draw(shown.current));
    size.observe(element);
    return () => size.disconnect();
  }, [draw]);
  return [canvas, draw];
}
