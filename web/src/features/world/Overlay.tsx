/** Drawn over the world: free starts, what is chosen with its grips, and places of problems. */
import { type Camera, toScreen } from "../../components/scene/camera";
import { startOf } from "../../model/starts";
import { useStudio } from "../../model/studio";
import type { Mission, OwnWorld } from "../../model/types";
import { dockPlace, lineOf, startPlace } from "../../model/world/drawing";
import { gripsOf } from "../../model/world/grips";
import { anchorOf } from "../../model/world/part-movement";
import { shapeOf } from "../../model/world/shape";
import { type PartReference, thingNamed } from "../../model/world/part-reference";

interface OverlayProps {
  world: OwnWorld;
  camera: Camera;
  chosen: readonly PartReference[];
  mission: Mission;
}

const HEADING_PX = 26;

type Point = readonly [number, number];

function pathOf(camera: Camera, points: readonly Point[], closed: boolean): string {
  const words = points.map(([x, y]) =>
    toScreen(camera, x, y)
      .map((px) => px.toFixed(1))
      .join(","),
  );
  return words.length === 0 ? "" : `M${words.join("L")}${closed ? "Z" : ""}`;
}

/** The outline of a thing; what has no shape of its own has a ring. */
function Outline({ world, camera, thing }: { world: OwnWorld; camera: Camera; thing: PartReference }) {
  const { kind, at } = thing;
  switch (kind) {
    case "wall": {
      const wall = world.walls[at];
      if (wall === undefined) return null;
      const points: Point[] = [
        [wall.x1, wall.y1],
        [wall.x2, wall.y2],
      ];
      return <path className="drawn" d={pathOf(camera, points, false)} />;
    }
    case "floor":
    case "line":
    case "road": {
      const part = kind === "floor" ? world.floors[at] : kind === "line" ? world.lines[at] : world.roads[at];
      if (part === undefined) return null;
      const closed = kind === "floor" || ("closed" in part && part.closed);
      const drawn = lineOf(part.points, closed)?.points ?? [];
      const corners = part.points.map(({ x, y }): Point => [x, y]);
      return (
        <>
          <path className="world-corners-line" d={pathOf(camera, corners, closed)} />
          <path className="drawn" d={pathOf(camera, drawn, closed)} />
        </>
      );
    }
    case "storehouse": {
      const house = world.storehouses[at];
      if (house === undefined) return null;
      const [x, y] = toScreen(camera, house.x_mm, house.y_mm + house.height_mm);
      const [width, height] = [house.width_mm * camera.scale, house.height_mm * camera.scale];
      return <rect className="drawn" x={x} y={y} width={width} height={height} rx="6" />;
    }
    case "box":
    case "ball":
    case "zone": {
      const shape = shapeOf(world, { kind, at });
      if (shape === null) return null;
      const [x, y] = toScreen(camera, shape.x, shape.y);
      const { scale } = camera;
      if (shape.radius > 0) return <circle className="drawn" cx={x} cy={y} r={shape.radius * scale} />;
      const [width, height] = [shape.width * scale, shape.height * scale];
      return <rect className="drawn" x={x - width / 2} y={y - height / 2} width={width} height={height} />;
    }
    case "dock":
    case "start": {
      const place = anchorOf(world, thing);
      if (place === null) return null;
      const [cx, cy] = toScreen(camera, place.x, place.y);
      return <circle className="drawn" cx={cx} cy={cy} r={Math.max(16, 75 * camera.scale)} />;
    }
  }
}

function Free({ world, camera, mission }: { world: OwnWorld; camera: Camera; mission: Mission }) {
  const taken = new Set(mission.agents.map(startOf));
  return (
    <>
      {world.starts.map((start, at) => {
        const place = taken.has(start.name) ? null : startPlace(world, start);
        if (place === null) return null;
        const [x, y] = toScreen(camera, place.x, place.y);
        const tip = [x + HEADING_PX * Math.cos(place.heading), y - HEADING_PX * Math.sin(place.heading)];
        return (
          <g key={at} className="world-free">
            <line x1={x} y1={y} x2={tip[0]} y2={tip[1]} />
            <circle cx={x} cy={y} r="10" />
            <text x={x} y={y + 26} textAnchor="middle">
              {start.name}
            </text>
          </g>
        );
      })}
    </>
  );
}

/** The names of docks, which the arena leaves out. */
function DockNames({ world, camera }: { world: OwnWorld; camera: Camera }) {
  return (
    <>
      {world.docks.map((dock, at) => {
        const place = dockPlace(world, dock);
        if (place === null) return null;
        const [x, y] = toScreen(camera, place.x, place.y);
        return (
          <text key={at} className="world-dock-name" x={x} y={y + 5} textAnchor="middle">
            {dock.name}
          </text>
        );
      })}
    </>
  );
}

export function Overlay({ world, camera, chosen, mission }: OverlayProps) {
  const report = useStudio((studio) => studio.report);
  const wrong = (report?.problems ?? []).flatMap((problem) => {
    const thing = thingNamed(world, problem.thing);
    return thing === null ? [] : [thing];
  });
  const [first] = chosen;
  const [left, top] = toScreen(camera, 0, world.height_mm);
  const grips = first === undefined || chosen.length > 1 ? [] : gripsOf(world, first);
  const anchor = first?.kind === "start" ? anchorOf(world, first) : null;
  return (
    <svg className="world-overlay passive" aria-hidden="true">
      <rect
        className="world-border"
        x={left}
        y={top}
        width={world.width_mm * camera.scale}
        height={world.height_mm * camera.scale}
      />
      <DockNames world={world} camera={camera} />
      <Free world={world} camera={camera} mission={mission} />
      {chosen.map((thing) => (
        <Outline key={`${thing.kind}${String(thing.at)}`} world={world} camera={camera} thing={thing} />
      ))}
      {wrong.map((thing, index) => {
        const place = anchorOf(world, thing);
        if (place === null) return null;
        const [x, y] = toScreen(camera, place.x, place.y);
        return (
          <g key={index} className="world-wrong" data-testid={`wrong-${thing.kind}-${String(thing.at)}`}>
            <circle cx={x} cy={y - 20} r="10" />
            <text x={x} y={y - 15} textAnchor="middle">
              !
            </text>
          </g>
        );
      })}
      {grips.map(({ id, x, y }) => {
        const [cx, cy] = toScreen(camera, x, y);
        const arm = id === "heading" && anchor !== null ? toScreen(camera, anchor.x, anchor.y) : null;
        return (
          <g key={id} className="world-grip" data-kind={id.split(":")[0]}>
            {arm === null ? null : <line className="world-arm" x1={arm[0]} y1={arm[1]} x2={cx} y2={cy} />}
            <circle className="world-grip-shape" cx={cx} cy={cy} r="6" />
            <circle className="world-grip-reach" cx={cx} cy={cy} r="14" data-grip={id} data-testid={`grip-${id}`} />
          </g>
        );
      })}
    </svg>
  );
}
