/**
 * Boxes, balls and walls are taken to another place in the arena itself, before a run: dragged with the mouse or a finger, or
 * taken with M and moved with the arrows, as robots are too. Each is one step of undo; a world of a file is copied first.
 */
import "./placing.css";

import { type RefObject, useEffect, useRef, useState } from "react";

import { partsApi } from "../../api/parts";
import { toScreen, toWorld } from "../../components/scene/camera";
import type { Painter } from "../../components/scene/painter";
import { sceneBefore } from "../../components/scene/scene";
import { t } from "../../i18n/words";
import { startOf } from "../../model/starts";
import { useStudio } from "../../model/studio";
import type { Mission, OwnWorld } from "../../model/types";
import { drawnWorld } from "../../model/world/drawing";
import { snapped, thingAt } from "../../model/world/hit-test";
import { anchorOf, moved } from "../../model/world/part-movement";
import { nameOf } from "../../model/world/names";
import { shapeOf } from "../../model/world/shape";
import { type Kind, partsOfKind, isSamePart, type PartReference } from "../../model/world/part-reference";
import { keyIn } from "../../session/key-table";
import { keepMoved } from "../../session/world-edits";
import { awaitAnswer, endAll, listen } from "../../ui/effects";
import { ARENA_KEYS } from "./keys";
import { announce } from "./robots";

const KINDS: readonly Kind[] = ["ball", "box", "wall"];
const [REACH_PX, CLICK_PX, RING_PX] = [8, 4, 26];
const STEPS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

interface PartPlacementProps {
  painter: Painter;
  canvas: RefObject<HTMLCanvasElement | null>;
  selected: string;
}

interface Drag {
  thing: PartReference;
  began: OwnWorld;
  x: number;
  y: number;
  px: number;
  py: number;
  draft: OwnWorld | null;
}

/** The robots of the mission by their starts, then boxes, balls and walls. */
export function movable(world: OwnWorld, mission: Mission): PartReference[] {
  const starts = new Set(mission.agents.map(startOf));
  const things = (["start", "box", "ball", "wall"] as const).flatMap((kind) =>
    partsOfKind(world, kind).map((_, at): PartReference => ({ kind, at })),
  );
  return things.filter(({ kind, at }) => kind !== "start" || starts.has(world.starts[at]?.name ?? ""));
}

/** What the mission's world is made of; null until it is known. */
function usePlan(): OwnWorld | null {
  const own = useStudio((studio) => studio.mission.own_world ?? null);
  const href = useStudio((studio) => studio.mission.world);
  const path = useStudio((studio) => studio.file.path);
  const [fetched, setFetched] = useState<{ of: string; world: OwnWorld | null } | null>(null);
  const of = `${path}\n${href}`;
  useEffect(() => {
    if (own !== null) return;
    // Whoever cannot have it moves the view instead; the list of problems says why.
    return awaitAnswer(partsApi.plan(path, href), ({ world }) => setFetched({ of: `${path}\n${href}`, world }));
  }, [own, href, path]);
  return own ?? (fetched?.of === of ? fetched.world : null);
}

export function PartPlacement({ painter, canvas: place, selected }: PartPlacementProps) {
  const plan = usePlan();
  const [taken, setTaken] = useState<PartReference | null>(null);
  const latest = useRef({ plan, taken, selected });
  useEffect(() => {
    latest.current = { plan, taken, selected };
  });
  useEffect(() => {
    const canvas = place.current;
    if (canvas === null) return;
    let drag: Drag | null = null;
    const pixel = (event: PointerEvent): [number, number] => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    const show = (world: OwnWorld) => {
      const { mission, catalogue } = useStudio.getState();
      painter.setScene(sceneBefore(mission, drawnWorld(world), catalogue), latest.current.selected);
    };
    const onDown = (event: PointerEvent) => {
      const world = latest.current.plan;
      const [px, py] = pixel(event);
      setTaken(null);
      if (event.button !== 0 || world === null) return;
      if (painter.actorAt(px, py) !== null || painter.keyAt(px, py) !== null) return;
      const [x, y] = toWorld(painter.camera, px, py);
      const thing = thingAt(world, x, y, REACH_PX / painter.camera.scale, KINDS);
      if (thing === null) return;
      event.stopPropagation();
      canvas.setPointerCapture(event.pointerId);
      drag = { thing, began: world, x, y, px, py, draft: null };
    };
    const onMove = (event: PointerEvent) => {
      if (drag === null) return;
      event.stopPropagation();
      const [px, py] = pixel(event);
      if (drag.draft === null && Math.hypot(px - drag.px, py - drag.py) < CLICK_PX) return;
      const anchor = anchorOf(drag.began, drag.thing);
      if (anchor === null) return;
      const [x, y] = toWorld(painter.camera, px, py);
      const wanted = { x: anchor.x + x - drag.x, y: anchor.y + y - drag.y };
      const to = event.altKey
        ? { x: Math.round(wanted.x), y: Math.round(wanted.y) }
        : snapped(wanted.x, wanted.y, [], 0);
      drag.draft = moved(drag.began, drag.thing, to.x - anchor.x, to.y - anchor.y);
      show(drag.draft);
    };
    const onUp = (event: PointerEvent) => {
      if (drag === null) return;
      event.stopPropagation();
      const { thing, began, draft } = drag;
      drag = null;
      setTaken(thing);
      if (draft !== null) keepMoved(began, draft, t("command.move", { name: nameOf(began, thing) }));
    };
    const onCancel = () => {
      if (drag !== null) show(drag.began);
      drag = null;
    };
    const onKey = (event: KeyboardEvent) => {
      const { plan: world, taken: held } = latest.current;
      if (world === null || event.ctrlKey || event.metaKey || event.altKey) return;
      const step = STEPS[event.key];
      if (keyIn(ARENA_KEYS, event) === "take") {
        const things = movable(world, useStudio.getState().mission);
        const at = held === null ? -1 : things.findIndex((one) => isSamePart(one, held));
        const next = things[(at + (event.shiftKey ? things.length - 1 : 1) + things.length) % things.length];
        if (next === undefined) return;
        setTaken(next);
        announce(t("arena.taken", { name: nameOf(world, next) }));
      } else if (held !== null && step !== undefined) {
        const mm = event.shiftKey ? 10 : 1;
        const after = moved(world, held, step[0] * mm, step[1] * mm);
        const label = t("command.move", { name: nameOf(world, held) });
        keepMoved(world, after, label, `arena-move ${held.kind}${String(held.at)}`);
      } else if (event.key === "Escape" && (held !== null || drag !== null)) {
        onCancel();
        setTaken(null);
      } else return;
      event.preventDefault();
      event.stopPropagation();
    };
    const listeners = { pointerdown: onDown, pointermove: onMove, pointerup: onUp, pointercancel: onCancel };
    return endAll(onCancel, listen(canvas, { ...listeners, keydown: onKey }));
  }, [painter, place]);
  return (
    <div hidden={taken === null} data-testid="arena-placing" data-ready={plan !== null}>
      {taken === null || plan === null ? null : <Ring painter={painter} world={plan} thing={taken} />}
    </div>
  );
}

/** Around the thing that is taken, wherever the view goes. */
function Ring({ painter, world, thing }: { painter: Painter; world: OwnWorld; thing: PartReference }) {
  const [view, setView] = useState(painter.camera);
  useEffect(() => {
    let request = 0;
    const follow = () => {
      setView(painter.camera);
      request = requestAnimationFrame(follow);
    };
    follow();
    return () => cancelAnimationFrame(request);
  }, [painter]);
  const { kind, at } = thing;
  const anchor = anchorOf(world, thing);
  if (anchor === null) return null;
  if (kind === "wall") {
    const wall = world.walls[at];
    if (wall === undefined) return null;
    const [x1, y1] = toScreen(view, wall.x1, wall.y1);
    const [x2, y2] = toScreen(view, wall.x2, wall.y2);
    return (
      <svg className="arena-taken cover passive" aria-hidden="true" data-testid="arena-taken">
        <line x1={x1} y1={y1} x2={x2} y2={y2} />
      </svg>
    );
  }
  const shape = kind === "box" || kind === "ball" ? shapeOf(world, { kind, at }) : null;
  const size = shape === null ? 0 : shape.radius || Math.hypot(shape.width, shape.height) / 2;
  const [cx, cy] = toScreen(view, anchor.x, anchor.y);
  return (
    <svg className="arena-taken cover passive" aria-hidden="true" data-testid="arena-taken">
      <circle cx={cx} cy={cy} r={Math.max(size * view.scale + 5, shape === null ? RING_PX : 0)} />
    </svg>
  );
}
