/**
 * What mouse and fingers do on the arena's canvas: they choose a robot, take it to another place before a run, press the keys
 * of a drawn board, and move the view; a right click, or a finger that rests, opens the menu of a robot.
 */
import { type MouseEvent, type PointerEvent, type RefObject, useCallback, useEffect, useRef } from "react";

import { toWorld } from "../../components/scene/camera";
import type { Painter } from "../../components/scene/painter";
import type { Scene } from "../../components/scene/scene";
import { startOf } from "../../model/starts";
import { useStudio } from "../../model/studio";
import { GRID_MM } from "../../model/world/part-reference";
import { watchPinch } from "../../ui/pinch";
import { choose, openRobotMenu, stopFollowing, useRobots } from "./robots";

const CLICK_PX = 4;
const NOWHERE = { scale: 1, x: 0, y: 0 };
/** How long a finger rests on a robot to open its menu. */
const REST_MS = 550;

/** Who takes the world into the hand follows nobody any more. */
function letRobotGo(): void {
  if (useRobots.getState().followed !== "") stopFollowing();
}

interface ArenaPointer {
  onContextMenu: (event: MouseEvent) => void;
  onPointerDown: (event: PointerEvent<HTMLCanvasElement>) => void;
  onPointerMove: (event: PointerEvent<HTMLCanvasElement>) => void;
  onPointerUp: (event: PointerEvent<HTMLCanvasElement>) => void;
  onPointerCancel: (event: PointerEvent<HTMLCanvasElement>) => void;
}

/** The handlers of the canvas that `painter` draws on. */
export function useArenaPointer(
  canvas: RefObject<HTMLCanvasElement | null>,
  painter: Painter | null,
  scene: Scene | null,
): ArenaPointer {
  /** Keys of drawn boards that pointers hold, by the pointer. */
  const holding = useRef(new Map<number, { agent: string; sensor: string }>());
  const grip = useRef<{ x: number; y: number; moved: boolean; actor: string } | null>(null);
  const resting = useRef<ReturnType<typeof setTimeout>>(undefined);

  const menuAt = (x: number, y: number) => {
    const place = canvas.current?.getBoundingClientRect();
    if (place === undefined) return;
    const found = painter?.actorAt(x - place.left, y - place.top);
    if (found === null || found === undefined) return;
    choose(found.actor);
    openRobotMenu(found.actor.name, x, y);
  };
  const onPointerDown = (event: PointerEvent<HTMLCanvasElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    const { clientX: x, clientY: y } = event;
    const place = event.currentTarget.getBoundingClientRect();
    const key = painter?.keyAt(x - place.left, y - place.top) ?? null;
    if (key !== null && painter?.boards?.press(key.agent, key.sensor) === true) {
      holding.current.set(event.pointerId, key);
      return;
    }
    if (!event.isPrimary) return;
    // Before a run a robot can be taken to another place; during one it is where it is.
    const found = scene?.running === false ? painter?.actorAt(x - place.left, y - place.top) : null;
    grip.current = { x, y, moved: false, actor: found?.actor.name ?? "" };
    if (event.pointerType === "mouse") return;
    resting.current = setTimeout(() => {
      grip.current = null;
      menuAt(x, y);
    }, REST_MS);
  };
  const onContextMenu = (event: MouseEvent) => {
    event.preventDefault();
    // A key opens it where the keyboard's robot is; a finger that rests has its own timer.
    if (event.button === 2) menuAt(event.clientX, event.clientY);
  };
  const onPointerMove = (event: PointerEvent<HTMLCanvasElement>) => {
    const held = grip.current;
    if (held === null) {
      const place = event.currentTarget.getBoundingClientRect();
      const key = painter?.keyAt(event.clientX - place.left, event.clientY - place.top) ?? null;
      event.currentTarget.style.cursor = key === null ? "" : "pointer";
      return;
    }
    const [dx, dy] = [event.clientX - held.x, event.clientY - held.y];
    if (!held.moved && Math.hypot(dx, dy) < CLICK_PX) return;
    clearTimeout(resting.current);
    if (held.actor !== "") {
      const place = canvas.current?.getBoundingClientRect();
      painter?.carry(held.actor, event.clientX - (place?.left ?? 0), event.clientY - (place?.top ?? 0));
      grip.current = { ...held, moved: true };
      return;
    }
    letRobotGo();
    painter?.pan(dx, dy);
    grip.current = { ...held, x: event.clientX, y: event.clientY, moved: true };
  };
  const drop = (actor: string, event: PointerEvent<HTMLCanvasElement>) => {
    const place = event.currentTarget.getBoundingClientRect();
    const [x, y] = toWorld(painter?.camera ?? NOWHERE, event.clientX - place.left, event.clientY - place.top);
    const grid = event.altKey ? 1 : GRID_MM;
    const agent = useStudio.getState().mission.agents.find((one) => one.name === actor);
    if (agent === undefined) return;
    void import("../../session/world-edits")
      .then(({ moveStart }) => moveStart(startOf(agent), Math.round(x / grid) * grid, Math.round(y / grid) * grid))
      .finally(() => painter?.putDown());
  };
  const letGo = ({ pointerId }: PointerEvent) => {
    const key = holding.current.get(pointerId);
    if (key !== undefined) painter?.boards?.release(key.agent, key.sensor);
    holding.current.delete(pointerId);
  };
  /** What one finger or the mouse began, without an effect. */
  const dropGrip = useCallback(() => {
    painter?.putDown();
    clearTimeout(resting.current);
    grip.current = null;
  }, [painter]);
  useEffect(() => {
    const drawn = canvas.current;
    if (drawn === null || painter === null) return;
    return watchPinch(drawn, {
      begin: () => {
        // Two fingers press two keys of a board.
        if (holding.current.size > 0) return false;
        dropGrip();
        return true;
      },
      move: (before, now) => {
        letRobotGo();
        painter.pan(now.x - before.x, now.y - before.y);
        painter.zoom(now.far / before.far, now.x, now.y);
      },
    });
  }, [canvas, painter, dropGrip]);
  const onPointerUp = (event: PointerEvent<HTMLCanvasElement>) => {
    letGo(event);
    const held = grip.current;
    grip.current = null;
    clearTimeout(resting.current);
    if (held !== null && held.moved && held.actor !== "") {
      drop(held.actor, event);
      return;
    }
    if (held === null || held.moved) return;
    const place = event.currentTarget.getBoundingClientRect();
    const [x, y] = [event.clientX - place.left, event.clientY - place.top];
    if (painter?.closeTagAt(x, y) === true) return;
    const found = painter?.actorAt(x, y);
    if (found === null || found === undefined) return;
    choose(found.actor);
  };
  const onPointerCancel = (event: PointerEvent<HTMLCanvasElement>) => {
    letGo(event);
    dropGrip();
  };
  return { onContextMenu, onPointerDown, onPointerMove, onPointerUp, onPointerCancel };
}
