/** A world with robots that drive the ways of a preview, over and over; or as they stand in the end. */
import { useEffect, useState } from "react";

import type { Track, World } from "../../api/generated";
import { WorldPicture } from "../../components/WorldPicture";
import { Robot } from "./Robot";

/** Points of a track a second. */
const PACE = 10;
/** How long the end is shown before it begins again, in seconds. */
const REST_S = 1;
const ROBOT_PART = 0.075;
/** Around what was driven, in a close view. */
const MARGIN = 0.18;

interface StageProps {
  world: World;
  tracks: readonly Track[];
  /** Only the end is shown. */
  still?: boolean;
  /** As near as what is driven allows. */
  close?: boolean;
}

function useMoment(length: number, still: boolean): number {
  const [moment, setMoment] = useState(0);
  const stands = still || length < 2 || matchMedia("(prefers-reduced-motion: reduce)").matches;
  useEffect(() => {
    if (stands) return;
    let frame = 0;
    const began = performance.now();
    const next = (now: number) => {
      const seconds = ((now - began) / 1000) % ((length - 1) / PACE + REST_S);
      setMoment(Math.min(length - 1, seconds * PACE));
      frame = requestAnimationFrame(next);
    };
    frame = requestAnimationFrame(next);
    return () => cancelAnimationFrame(frame);
  }, [length, stands]);
  return stands ? length - 1 : moment;
}

type Point = [number, number, number];

/** Where a robot is between two points of its way. */
function at(points: readonly Point[], moment: number): Point {
  const whole = Math.min(points.length - 1, Math.floor(moment));
  const [x, y, heading] = points[whole] ?? [0, 0, 0];
  const [x2, y2, heading2] = points[whole + 1] ?? [x, y, heading];
  const part = moment - whole;
  const turned = Math.atan2(Math.sin(heading2 - heading), Math.cos(heading2 - heading));
  return [x + (x2 - x) * part, y + (y2 - y) * part, heading + turned * part];
}

function box(world: World, tracks: readonly Track[], close: boolean): [number, number, number, number] {
  const { width_mm: width, height_mm: height } = world;
  const points = tracks.flatMap((track) => track.points);
  if (!close || points.length === 0 || tracks.length > 1) return [0, 0, width, height];
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [low, high] = [Math.min(...ys), Math.max(...ys)];
  const side = Math.max(right - left, high - low, Math.min(width, height) / 8) * (1 + 2 * MARGIN);
  return [(left + right - side) / 2, height - (low + high + side) / 2, side, side];
}

export function Stage({ world, tracks, still = false, close = false }: StageProps) {
  const length = Math.max(0, ...tracks.map(({ points }) => points.length));
  const moment = useMoment(length, still);
  const view = box(world, tracks, close);
  const size = close && tracks.length === 1 ? view[2] * 0.24 : Math.max(135, world.width_mm * ROBOT_PART);
  const up = (y: number) => world.height_mm - y;
  return (
    <WorldPicture world={world} agents={[]} view={view}>
      {tracks.map(({ agent, points }) => (
        <polyline
          key={agent}
          className="new-track"
          points={points
            .slice(0, Math.ceil(moment) + 1)
            .map(([x, y]) => `${String(x)},${String(up(y))}`)
            .join(" ")}
        />
      ))}
      {tracks.map(({ agent, robot, points }, index) => {
        const [x, y, heading] = at(points, moment);
        return <Robot key={agent} kind={robot} index={index} x={x} y={up(y)} heading={heading} length={size} />;
      })}
    </WorldPicture>
  );
}
