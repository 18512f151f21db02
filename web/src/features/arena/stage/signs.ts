/**
 * What a run shows of robots: light of lamps under them; over them waves of a collision, badges of faults, different in shape
 * (✕ failed, ‖ stalled, a struck-out sender: no radio), and what the one that is watched senses.
 */
import { LAMP } from "../../../api/wire";
import { type Camera, toScreen } from "../../../components/scene/camera";
import { isCrowd } from "../../../components/scene/crowd-size";
import { keeperPlace, ringOf, scoreAt } from "../../../components/scene/draw-robots";
import { type Brush, robotUnit, write } from "../../../components/scene/draw-world";
import { drawGlow } from "../../../components/scene/figures";
import { fillWith, strokeWith } from "../../../components/scene/ink";
import type { PenStroke } from "../../../components/scene/pen-strokes";
import type { Scene, Seen } from "../../../components/scene/scene";
import { type Area, placeTag } from "../../../components/scene/tag-place";
import { fontOf } from "../../../theme";

const MOST_SENSES = 3;
/** Further than this from its robot no tag reaches. */
const TAG_PX = 420;

/** In units of a badge's radius, around its middle. */
const SIGNS = {
  failed: "M-.38-.38L.38.38M.38-.38L-.38.38",
  stalled: "M-.22-.4V.4M.22-.4V.4",
  muted: "M-.3-.02a.42.42 0 0 1 .6 0M-.52-.24a.74.74 0 0 1 1.04 0M0 .3V.32M-.5.5L.5-.5",
};

/** The light of lamps, under all bodies. */
export function drawGlows(brush: Brush, seen: readonly Seen[]): void {
  const { pen, camera, colours } = brush;
  for (const { actor, pose } of seen) {
    if ((pose.flags & LAMP) === 0 || actor.face !== null) continue;
    pen.save();
    pen.translate(...toScreen(camera, pose.x_mm, pose.y_mm));
    pen.rotate(-pose.heading_rad);
    drawGlow(pen, actor.figure, robotUnit(camera, actor.length_mm), colours.glow);
    pen.restore();
  }
}

/** What the collision sensor feels: waves before the bumper. */
function drawBump({ pen, colours, unit: u }: Brush): void {
  pen.lineCap = "round";
  pen.beginPath();
  for (const reach of [14, 20]) {
    pen.moveTo(20 * u + reach * Math.cos(0.7) * u, -reach * Math.sin(0.7) * u);
    pen.arc(20 * u, 0, reach * u, -0.7, 0.7);
  }
  strokeWith(pen, colours.ink, 1.75 * u);
  pen.lineCap = "butt";
}

/** At the upper right of a robot whose middle is at the origin; a second badge goes below the first. */
function drawBadges({ pen, colours }: Brush, unit: number, { failed, stalled, muted }: Seen): void {
  const r = Math.max(13 * unit, 8);
  const signs = [failed ? SIGNS.failed : stalled ? SIGNS.stalled : "", muted ? SIGNS.muted : ""].filter(Boolean);
  signs.forEach((sign, at) => {
    pen.save();
    pen.translate(Math.max(23 * unit, 8), Math.min(-23 * unit, -8) + at * 2.2 * r);
    pen.scale(r, r);
    pen.beginPath();
    pen.arc(0, 0, 1, 0, Math.PI * 2);
    fillWith(pen, colours.panel);
    strokeWith(pen, colours.ink, 0.15);
    pen.lineWidth = 0.2;
    pen.lineCap = "round";
    pen.stroke(new Path2D(sign));
    pen.restore();
  });
}

/** Waves and badges; a crowd draws its own. */
export function drawSigns(brush: Brush, scene: Scene, seen: readonly Seen[]): void {
  const { pen, camera } = brush;
  if (isCrowd(seen.length, camera.scale)) return;
  for (const one of seen) {
    if (!one.collided && !one.failed && !one.stalled && !one.muted) continue;
    const kept = one.actor.role === "keeper" ? keeperPlace(brush, scene, one) : null;
    if (kept === null && one.actor.role === "keeper") continue;
    const unit = kept?.unit ?? robotUnit(camera, one.actor.length_mm);
    pen.save();
    if (kept === null) pen.translate(...toScreen(camera, one.pose.x_mm, one.pose.y_mm));
    else pen.translate(kept.x, kept.y);
    if (one.collided) {
      pen.save();
      pen.rotate(-one.pose.heading_rad);
      drawBump({ ...brush, unit });
      pen.restore();
    }
    drawBadges(brush, unit, one);
    pen.restore();
  }
}

/** What the tag should not cover: storehouses, the score, the other robots. */
function takenAreas(brush: Brush, scene: Scene, seen: readonly Seen[], own: Seen): Area[] {
  const { camera, unit: u } = brush;
  const houses = scene.world.storehouses.map((house) => {
    const [left, top] = toScreen(camera, house.x_mm, house.y_mm + house.height_mm);
    return { left, top, width: house.width_mm * camera.scale, height: house.height_mm * camera.scale };
  });
  const around = (x_mm: number, y_mm: number, halfWidth: number, halfHeight: number): Area => {
    const [x, y] = toScreen(camera, x_mm, y_mm);
    return { left: x - halfWidth, top: y - halfHeight, width: 2 * halfWidth, height: 2 * halfHeight };
  };
  const others = seen
    .filter((one) => one !== own && one.actor.role !== "keeper")
    .map((one) => {
      const ring = ringOf(one.actor, robotUnit(camera, one.actor.length_mm));
      return around(one.pose.x_mm, one.pose.y_mm, ring, ring);
    });
  const middle = scoreAt(scene);
  const [left, top] = toScreen(camera, own.pose.x_mm, own.pose.y_mm);
  const shown = own.actor.indicators.map((_, row) => {
    const away = ringOf(own.actor, robotUnit(camera, own.actor.length_mm));
    return { left: left - 60, top: top + away + 18 * row, width: 120, height: 18 };
  });
  return [...houses, ...others, ...shown, ...(middle === null ? [] : [around(middle[0], middle[1], 55 * u, 28 * u)])];
}

/** A line that somebody drew, as areas along it that a tag leaves free. */
export function lineAreas(camera: Camera, lines: readonly PenStroke[], near: Area): Area[] {
  const [step, half] = [10, 8];
  const areas: Area[] = [];
  const inside = (x: number, y: number) =>
    x > near.left && x < near.left + near.width && y > near.top && y < near.top + near.height;
  for (const { points } of lines) {
    points.forEach((point, at) => {
      const [x0, y0] = toScreen(camera, ...(points[at - 1] ?? point));
      const [x1, y1] = toScreen(camera, ...point);
      const pieces = Math.max(1, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / step));
      for (let piece = 1; piece <= pieces; piece++) {
        const [x, y] = [x0 + ((x1 - x0) * piece) / pieces, y0 + ((y1 - y0) * piece) / pieces];
        if (inside(x, y)) areas.push({ left: x - half, top: y - half, width: 2 * half, height: 2 * half });
      }
    });
  }
  return areas;
}

interface Tag {
  awaited: ReadonlySet<string>;
  lines: readonly PenStroke[];
}

/** The tag beside the robot that is watched: what it waits for now, clear of what is drawn. Gives where it stands. */
export function drawTag(
  brush: Brush,
  scene: Scene,
  seen: readonly Seen[],
  one: Seen,
  { awaited, lines }: Tag,
): Area | null {
  const { pen, camera, room, colours } = brush;
  const { number, role, name } = one.actor;
  const senses = one.actor.senses.flatMap((sense) => (awaited.has(sense.name) ? [sense.words] : []));
  if (senses.length === 0 || role === "keeper") return null;
  const [x, y] = toScreen(camera, one.pose.x_mm, one.pose.y_mm);
  pen.font = fontOf(600, 13);
  const away = ringOf(one.actor, robotUnit(camera, one.actor.length_mm));
  const taken = [
    ...takenAreas(brush, scene, seen, one),
    ...lineAreas(camera, lines, { left: x - TAG_PX, top: y - TAG_PX, width: 2 * TAG_PX, height: 2 * TAG_PX }),
    { left: x - away, top: y - away, width: 2 * away, height: 2 * away },
  ];
  // As many senses as have room beside everybody; where not even one has, the panel of the stage and the watch tell them.
  const found = [...Array(Math.min(MOST_SENSES, senses.length)).keys()]
    .map((less) => {
      const few = senses.slice(0, Math.min(MOST_SENSES, senses.length) - less);
      const who = seen.length < 2 ? [] : [role === "robot" ? String(number) : name];
      const words = [...who, ...few, "✕"].join(" · ");
      const size = { width: pen.measureText(words).width + 24, height: 24 };
      return { words, place: placeTag(x, y, away, size, room, taken) };
    })
    .find(({ place }) => place.cost === 0);
  if (found === undefined) return null;
  const { words } = found;
  const { area, right, below } = found.place;
  const middle = area.top + area.height / 2;
  pen.beginPath();
  pen.moveTo(x + right * away * 0.72, y + below * away * 0.72);
  pen.lineTo(x + right * (away * 0.72 + 10), middle);
  pen.lineTo(right > 0 ? area.left : area.left + area.width, middle);
  strokeWith(pen, colours.ink, 1.5);
  pen.beginPath();
  pen.roundRect(area.left, area.top, area.width, area.height, 6);
  fillWith(pen, colours.ink);
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  write(brush, words, area.left + area.width / 2, middle + 0.5, 13, 600, colours.onInk);
  return area;
}
