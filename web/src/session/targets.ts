/**
 * Where a dragged thing would go if it were dropped now.
 *
 * Arcs and parallels are found in the layout; slots are found on the screen, because only it knows where in a vertex a chip
 * stands. The nearest place that takes the thing wins, within `reach`; farther from all of them is the void.
 */
import { stretchOf, wraps } from "../model/commands/wrapParts";
import { distanceToLine, type LayoutFrame, type LayoutNode, type Point } from "../model/layout";
import { fits, isMark, type Parts, type Shape, standsInChain, waitingFor } from "../model/parts";
import { findSpot, type Place, verticesOf, withMark } from "../model/tree";
import type { Drawing } from "./drawing";

export interface Target {
  place: Place;
  /** "arc:v1.body", "slot:v4.condition", "vertex:v3", "void": what lights up. */
  key: string;
}

/** Half the height of a vertex, which stands on the edge of its frame. */
const HALF_ROW = 22;

/** How near one must come, in px on the screen. */
export const REACH = 60;

export function target(place: Place): Target {
  switch (place.kind) {
    case "arc":
      return { place, key: `arc:${place.source}.${place.out}` };
    case "slot":
      return { place, key: `slot:${place.vertex}.${place.slot}` };
    case "vertex":
      return { place, key: `vertex:${place.vertex}` };
    case "void":
      return { place, key: "void" };
  }
}

/** The place in the layout under `point` for a thing of that shape; `moving` vertices are no place for themselves. */
export function targetInLayout(
  drawing: Drawing,
  point: Point,
  reach: number,
  shape: Shape,
  moving: Set<string>,
): Target | null {
  if (shape.role === "branch") return branchTarget(drawing, point, shape);
  if (isMark(shape) && moving.size === 0) {
    const action = nodeAt(
      drawing,
      point,
      0,
      (node) => node.mark === null && node.block?.shape.kind === "method" && !node.parked,
    );
    if (action !== undefined) return target({ kind: "vertex", vertex: action.vertex });
  }
  if (!standsInChain(shape) && !waits(drawing.parts, shape, moving.size > 0)) return target({ kind: "void" });
  return arcTarget(drawing, point, reach, moving) ?? firstTarget(drawing) ?? target({ kind: "void" });
}

/** Whether a drop into a chain makes the program wait for it there: a test that is new, and not taken from elsewhere. */
function waits(parts: Parts, shape: Shape, moves: boolean): boolean {
  return !moves && waitingFor(parts, shape) !== undefined;
}

/** In a program without parts the arc from Start to Stop, however far it is: what is dropped first runs. */
function firstTarget({ structure }: Drawing): Target | null {
  const isEmpty = structure.main.chain.length === 0 && structure.parked.length === 0;
  return isEmpty && structure.start !== null ? target({ kind: "arc", source: structure.start.id, out: "next" }) : null;
}

/** On a selected vertex, a part that holds others goes around the selection. */
export function wrapTarget(drawing: Drawing, point: Point, shape: Shape, selection: readonly string[]): Target | null {
  if (!wraps(shape) || stretchOf(drawing.structure, selection) === null) return null;
  const node = nodeAt(drawing, point, 0, ({ vertex }) => selection.includes(vertex));
  return node === undefined ? null : target({ kind: "vertex", vertex: node.vertex });
}

/** The arc into the innermost empty body whose frame the point is in, below its vertex. */
function bodyTarget({ layout, nodes }: Drawing, point: Point, moving: Set<string>): Target | null {
  let found: Target | null = null;
  for (const frame of layout.frames) {
    const out = nodes.get(frame.id)?.block?.shape.flows[0]?.name ?? "";
    const below = point.y > frame.y + HALF_ROW && contains(frame, point);
    if (!below) continue;
    const isOpen = nodes.get(`${frame.id}.${out}`)?.kind === "place" && !moving.has(frame.id);
    found = isOpen ? target({ kind: "arc", source: frame.id, out }) : null;
  }
  return found;
}

function arcTarget(drawing: Drawing, point: Point, reach: number, moving: Set<string>): Target | null {
  const body = bodyTarget(drawing, point, moving);
  if (body !== null) return body;
  const { layout } = drawing;
  const place = layout.nodes.find((node) => node.id === "place");
  let nearest = place !== undefined && contains(place, point) ? 0 : Infinity;
  let found = nearest === 0 ? layout.arcs[0] : undefined;
  for (const arc of layout.arcs) {
    const away = distanceToLine(arc.points, point);
    if (away >= nearest || away > reach || moving.has(arc.source)) continue;
    nearest = away;
    found = arc;
  }
  return found === undefined ? null : target({ kind: "arc", source: found.source, out: found.out });
}

/** The innermost constructor under the point to which the part adds a branch. */
function branchTarget({ layout, nodes }: Drawing, point: Point, shape: Shape): Target | null {
  const wanted = shape.constructor_?.adds?.constructor;
  let found: LayoutFrame | undefined;
  for (const frame of layout.frames) {
    if (nodes.get(frame.id)?.block?.shape.element === wanted && contains(frame, point, 24)) found = frame;
  }
  return found === undefined ? null : target({ kind: "vertex", vertex: found.id });
}

function nodeAt(
  { layout }: Drawing,
  point: Point,
  margin: number,
  which: (node: LayoutNode) => boolean,
): LayoutNode | undefined {
  return layout.nodes.find((node) => which(node) && contains(node, point, margin));
}

function contains(box: { x: number; y: number; w: number; h: number }, { x, y }: Point, margin = 0): boolean {
  return x >= box.x - margin && x <= box.x + box.w + margin && y >= box.y - margin && y <= box.y + box.h + margin;
}

/**
 * What takes a thing of that shape: the words of `data-accepts`, which lights these places up while it is dragged.
 * `moves`: it is taken from elsewhere in the program.
 */
export function acceptedPlaces(parts: Parts, shape: Shape, moves: boolean): string {
  if (shape.role === "branch") return "branches";
  const places = standsInChain(shape) || waits(parts, shape, moves) ? ["arcs"] : [];
  for (const accepts of ["condition", "value", "action"] as const) {
    if (fits(shape, { name: "", label: {}, accepts })) places.push(`${accepts}s`);
  }
  return places.join(" ");
}

/** Everything inside the given vertices, themselves and their marks included. */
export function insideOf({ structure }: Drawing, ids: string[]): Set<string> {
  const spots = ids.flatMap((id) => findSpot(structure, id) ?? []);
  return new Set(spots.flatMap((spot) => verticesOf(withMark(spot).block).map((vertex) => vertex.id)));
}

/** The nearest slot on the screen that the thing fits; `point` in px of the window. */
export function slotOnScreen(
  drawing: Drawing,
  root: Element,
  point: Point,
  shape: Shape,
  moving: Set<string>,
): Target | null {
  let nearest = REACH;
  let found: Place | null = null;
  for (const element of root.querySelectorAll<HTMLElement>("[data-slot]")) {
    const { vertex = "", slot = "" } = element.dataset;
    const owner = drawing.parts.shape(drawing.program.vertices.find((one) => one.id === vertex)?.element ?? "");
    const plug = owner.plugs.find((one) => one.name === slot);
    if (plug === undefined || !fits(shape, plug) || moving.has(vertex)) continue;
    const away = distanceToBox(element.getBoundingClientRect(), point);
    // An empty slot inside a chip wins over the chip.
    if (away > nearest || (away === nearest && found !== null && element.dataset["hole"] === undefined)) continue;
    nearest = away;
    found = { kind: "slot", vertex, slot };
  }
  return found === null ? null : target(found);
}

function distanceToBox(box: DOMRect, { x, y }: Point): number {
  return Math.hypot(Math.max(box.left - x, 0, x - box.right), Math.max(box.top - y, 0, y - box.bottom));
}
