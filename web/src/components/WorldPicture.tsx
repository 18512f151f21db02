/**
 * Small pictures that stand: a program's graph in the colours of its parts, laid out as on the canvas, and a world from
 * above with those who start in it. Nothing here has words; the card around it has.
 */
import { type ReactNode, useMemo } from "react";

import { headPath, hexagonPoints, layoutStructure, type LayoutNode, roundedPath } from "../model/layout";
import { partsOf } from "../model/parts";
import { readStructure } from "../model/structure";
import { useStudio } from "../model/studio";
import type { Program, World } from "../model/types";

import "./world-picture.css";

const MARGIN = 24;
/** Room above a robot's size in an open place, so that it can be seen in a small picture. */
const ROBOT_PART = 0.075;

export function GraphPicture({ program }: { program: Program }) {
  const catalogue = useStudio((studio) => studio.catalogue);
  const layout = useMemo(
    () => layoutStructure(readStructure(program, partsOf(catalogue, program.robot))),
    [catalogue, program],
  );
  const { x, y, w, h } = layout.bounds;
  const box = [x - MARGIN, y - MARGIN, w + 2 * MARGIN, h + 2 * MARGIN].join(" ");
  return (
    <svg className="picture" viewBox={box} aria-hidden="true">
      {layout.frames.map((frame) => (
        <rect
          key={`${frame.kind} ${frame.id}`}
          className="picture-frame"
          data-colour={frame.colour}
          x={frame.x}
          y={frame.y}
          width={frame.w}
          height={frame.h}
          rx={frame.kind === "parallel" ? 0 : 8}
        />
      ))}
      {layout.arcs.map((arc, index) => (
        <g key={index} className="picture-arc" data-colour={arc.colour}>
          <path d={roundedPath(arc.points, arc.head)} />
          {arc.head ? <path className="picture-head" d={headPath(arc.points)} /> : null}
        </g>
      ))}
      {layout.nodes.map((node) => (
        <NodeShape key={node.id} node={node} />
      ))}
    </svg>
  );
}

function NodeShape({ node }: { node: LayoutNode }) {
  const { kind, colour, x, y, w, h } = node;
  if (kind === "hexagon") return <polygon className="picture-node" data-colour={colour} points={hexagonPoints(node)} />;
  if (kind === "place") return <rect className="picture-place unscaled" x={x} y={y} width={w} height={h} rx={8} />;
  const end = kind === "start" || kind === "stop";
  const flat = kind === "bar" || kind === "barEnd";
  // A bar is thin on its box; here the box would be a slab.
  const height = flat ? 12 : h;
  return (
    <rect
      className={end ? "picture-end unscaled" : "picture-node"}
      data-colour={colour}
      x={x}
      y={y + (h - height) / 2}
      width={w}
      height={height}
      rx={end ? h / 2 : 8}
    />
  );
}

/** Who keeps a storehouse stands in it, under its boxes. */
function isIndoors({ x_mm, y_mm }: World["starts"][number], { storehouses }: World): boolean {
  return storehouses.some(
    (house) =>
      x_mm >= house.x_mm &&
      x_mm <= house.x_mm + house.width_mm &&
      y_mm >= house.y_mm &&
      y_mm <= house.y_mm + house.height_mm,
  );
}

interface WorldPictureProps {
  world: World;
  /** Whose starts are shown, by their names in the world. */
  agents: readonly string[];
  /** What is drawn above it, in mm, with y downward. */
  children?: ReactNode;
}

/** A world from above, with those who start in it. */
export function WorldPicture({ world, agents, children }: WorldPictureProps) {
  const { width_mm: width, height_mm: height } = world;
  const size = Math.max(135, width * ROBOT_PART);
  const path = (points: [number, number][], closed: boolean) =>
    `M${points.map(([x, y]) => `${String(x)} ${String(height - y)}`).join("L")}${closed ? "Z" : ""}`;
  return (
    <svg className="picture picture-world" viewBox={[0, 0, width, height].join(" ")} aria-hidden="true">
      {world.floors.map((floor, index) => (
        <path
          key={index}
          className="picture-floor"
          d={path(floor.points, true)}
          style={{ fill: `var(--arena-${floor.colour})` }}
        />
      ))}
      {world.lines.map((line, index) => (
        <path
          key={index}
          d={path(line.points, line.closed)}
          style={{ stroke: `var(--arena-${line.colour})`, strokeWidth: line.width_mm }}
        />
      ))}
      {world.roads.map((road) => (
        <path
          key={road.name}
          className="picture-road"
          d={path(road.points, road.closed)}
          style={{ strokeWidth: road.width_mm }}
        />
      ))}
      {world.walls.map(({ x1, y1, x2, y2 }, index) => (
        <line key={index} className="picture-wall unscaled" x1={x1} y1={height - y1} x2={x2} y2={height - y2} />
      ))}
      {(world.zones ?? []).map((zone, index) => {
        const [x, y] = [zone.x_mm, height - zone.y_mm];
        const shape = { className: "picture-zone", "data-kind": zone.kind };
        if (zone.radius_mm > 0) return <circle key={index} {...shape} cx={x} cy={y} r={zone.radius_mm} />;
        const [wide, high] = [zone.width_mm, zone.height_mm];
        return <rect key={index} {...shape} x={x - wide / 2} y={y - high / 2} width={wide} height={high} />;
      })}
      {world.storehouses.map((house) => (
        <g
          key={house.name}
          transform={`translate(${String(house.x_mm)} ${String(height - house.y_mm - house.height_mm)})`}
        >
          <rect className="picture-house unscaled" width={house.width_mm} height={house.height_mm} rx="12" />
          {Array.from({ length: Math.min(house.stock, 12) }, (_, k) => (
            <rect
              key={k}
              className="picture-box"
              x={house.width_mm * (0.12 + (k % 3) * 0.27)}
              y={house.height_mm * (0.07 + Math.floor(k / 3) * 0.23)}
              width={house.width_mm * 0.22}
              height={house.width_mm * 0.22}
            />
          ))}
        </g>
      ))}
      {world.starts
        .filter((start) => agents.includes(start.name) && !isIndoors(start, world))
        .map(({ name, x_mm, y_mm, heading_rad }) => (
          <g
            key={name}
            transform={`translate(${String(x_mm)} ${String(height - y_mm)}) rotate(${String((-heading_rad * 180) / Math.PI)}) scale(${String(size / 54)})`}
          >
            <rect className="picture-robot unscaled" x="-27" y="-19" width="54" height="38" rx="9" />
            <path className="picture-front unscaled" d="M14 -11V11" />
          </g>
        ))}
      {children}
    </svg>
  );
}
