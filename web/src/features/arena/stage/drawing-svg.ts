/** What pens drew as an SVG file, as `kitrobot run --drawing` writes it; with the floor under it, as with `--floor`. */
import { PEN_COLOURS, type PenStroke } from "../../../components/scene/pen-strokes";
import type { World } from "../../../model/types";

const INK = "#1b1f27";
const GROUND = "#eceee9";
const FLOOR = { red: "#d3202f", green: "#1c8548", blue: "#1d6ad4" } as const;
const ZONES = { warm: "#c2650f", loud: "#7549cc", bright: "#946500" } as const;
const [ROAD, WALL, WALL_MM] = ["#cdd2da", "#5b6472", 8];

type Points = readonly (readonly [number, number])[];

function number(value: number): string {
  const text = value.toFixed(1).replace(/\.0$/, "");
  return text === "-0" ? "0" : text;
}

function path(points: Points, high: number): string {
  return points.map(([x, y], at) => `${at > 0 ? "L" : "M"}${number(x)} ${number(high - y)}`).join(" ");
}

function floorOf(world: World): string[] {
  const high = world.height_mm;
  const shape = (points: Points, closed: boolean) => `d="${path(points, high)}${closed ? "Z" : ""}"`;
  const width = (mm: number) => `stroke-width="${number(mm)}"`;
  return [
    `<rect width="${number(world.width_mm)}" height="${number(high)}" fill="${GROUND}"/>`,
    ...world.floors.map(
      ({ colour, points }) =>
        `<path ${shape(points, true)} fill="${FLOOR[colour]}" fill-opacity="0.5" fill-rule="evenodd"/>`,
    ),
    ...(world.zones ?? []).map((zone) => {
      const hue = ZONES[zone.kind];
      const colour = `fill="${hue}" fill-opacity="0.15" stroke="${hue}" stroke-width="4"`;
      const [x, y, wide, tall] = [zone.x_mm, high - zone.y_mm, zone.width_mm, zone.height_mm];
      if (zone.radius_mm > 0) {
        return `<circle cx="${number(x)}" cy="${number(y)}" r="${number(zone.radius_mm)}" ${colour}/>`;
      }
      const place = `x="${number(x - wide / 2)}" y="${number(y - tall / 2)}"`;
      return `<rect ${place} width="${number(wide)}" height="${number(tall)}" ${colour}/>`;
    }),
    ...world.lines.map(
      ({ colour, width_mm, closed, points }) =>
        `<path ${shape(points, closed)} stroke="${FLOOR[colour]}" ${width(width_mm)}/>`,
    ),
    ...world.roads.map(
      ({ width_mm, closed, points }) => `<path ${shape(points, closed)} stroke="${ROAD}" ${width(width_mm)}/>`,
    ),
    ...world.walls.map(({ x1, y1, x2, y2 }) => {
      const points = [[x1, y1] as const, [x2, y2] as const];
      return `<path ${shape(points, false)} stroke="${WALL}" stroke-width="${String(WALL_MM)}"/>`;
    }),
  ];
}

export function drawingSvg(strokes: readonly PenStroke[], world: World, floor: boolean): string {
  const [width, height] = [number(world.width_mm), number(world.height_mm)];
  const lines = strokes.map(({ colour, width_mm, points }) => {
    const tidy = points.map(([x, y]): [number, number] => [Math.round(x * 10) / 10, Math.round(y * 10) / 10]);
    const corners = tidy.filter(([x, y], at) => at === 0 || x !== tidy[at - 1]?.[0] || y !== tidy[at - 1]?.[1]);
    // A dot is a line to where it began.
    const drawn = path(corners, world.height_mm) + (corners.length === 1 ? " h0" : "");
    return `<path d="${drawn}" stroke="${PEN_COLOURS[colour] ?? INK}" stroke-width="${String(width_mm)}"/>`;
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}mm" height="${height}mm" ` +
      `viewBox="0 0 ${width} ${height}" fill="none" stroke-linecap="round" stroke-linejoin="round">`,
    ...[...(floor ? floorOf(world) : []), ...lines].map((line) => `  ${line}`),
    "</svg>",
    "",
  ].join("\n");
}
