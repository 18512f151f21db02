/**
 * The place itself: drawn as the arena draws it, with what is chosen, its grips and its problems over it.
 *
 * A press takes hold of what is there, or with a tool in hand draws something new; dragging the ground moves the view. While
 * something is dragged only a draft changes. Places go to the grid and to the ends of walls and lines; Alt lets them be free.
 */
import { type KeyboardEvent, type PointerEvent, useEffect, useMemo, useRef, useState } from "react";

import { type Camera, toWorld } from "../../components/scene/camera";
import { Painter } from "../../components/scene/painter";
import { sceneBefore } from "../../components/scene/scene";
import { handKey } from "../../i18n/touch";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { OwnWorld } from "../../model/types";
import { drawnWorld } from "../../model/world/drawing";
import { endsOf, snapped, thingAt } from "../../model/world/hit-test";
import { dragged } from "../../model/world/grips";
import { drawNew, type Spot } from "../../model/world/part-creation";
import { anchorOf, moved } from "../../model/world/part-movement";
import { KIND_ICONS, kindName, nameOf } from "../../model/world/names";
import { type Kind, isSamePart, type PartReference, partReferences } from "../../model/world/part-reference";
import { keyIn } from "../../session/key-table";
import { called, change, duplicateChosen, nudge, put, removeChosen } from "../../session/world-edits";
import { choose, chosenIn, putDown, setDraft, useWorld } from "../../session/world-view";
import { Icon, useTheme } from "../../theme";
import { watchPinch } from "../../ui/pinch";
import { WORLD_KEYS } from "./keys";
import { Overlay } from "./Overlay";

const MARGIN_PX = 40;
const REACH_PX = 8;
const CLICK_PX = 4;
const PAN_PX = 40;

type Drag =
  | { what: "pan"; x: number; y: number; moved: boolean }
  | { what: "grip"; thing: PartReference; grip: string; began: OwnWorld }
  | { what: "move"; from: Spot; x: number; y: number; held: boolean; began: OwnWorld; things: PartReference[] }
  | { what: "new"; tool: Kind; from: Spot; x: number; y: number; began: OwnWorld };

function scaleOf(camera: Camera): number {
  return REACH_PX / camera.scale;
}

export function Stage() {
  const mission = useStudio((studio) => studio.mission);
  const fromFile = useStudio((studio) => studio.world);
  const draft = useWorld((state) => state.draft);
  const tool = useWorld((state) => state.tool);
  const chosen = useWorld((state) => state.chosen);
  const theme = useTheme((state) => state.theme);
  const own = mission.own_world ?? null;
  const now = own === null ? null : (draft ?? own);
  const world = now === null ? fromFile : drawnWorld(now);
  const catalogue = useStudio((studio) => studio.catalogue);
  const scene = useMemo(
    () => (world === null ? null : sceneBefore(mission, world, catalogue)),
    [mission, world, catalogue],
  );
  const frame = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const drag = useRef<Drag | null>(null);
  const [painter, setPainter] = useState<Painter | null>(null);
  const [camera, setCamera] = useState<Camera | null>(null);

  useEffect(() => {
    const [box, drawn] = [frame.current, canvas.current];
    if (box === null || drawn === null) return;
    const made = new Painter(drawn, () => false, setCamera, MARGIN_PX);
    setPainter(made);
    return made.attachTo(box);
  }, []);
  useEffect(() => {
    if (scene !== null) painter?.setScene(scene, "");
  }, [painter, scene]);
  useEffect(() => {
    painter?.themeChanged();
  }, [painter, theme]);
  useEffect(() => {
    const box = frame.current;
    if (box === null || painter === null) return;
    return watchPinch(box, {
      begin: () => {
        drag.current = null;
        setDraft(null);
        return true;
      },
      move: (before, now) => {
        painter.pan(now.x - before.x, now.y - before.y);
        painter.zoom(now.far / before.far, now.x, now.y);
      },
    });
  }, [painter]);
  // A draft belongs to a drag of this stage.
  useEffect(() => putDown, []);

  const spot = (event: PointerEvent): Spot => {
    const place = frame.current?.getBoundingClientRect();
    const view = painter?.camera;
    if (place === undefined || view === undefined) return { x: 0, y: 0 };
    const [x, y] = toWorld(view, event.clientX - place.left, event.clientY - place.top);
    return { x, y };
  };
  const snap = (event: PointerEvent, { x, y }: Spot, but: readonly PartReference[]): Spot => {
    if (event.altKey || now === null || painter === null) return { x: Math.round(x), y: Math.round(y) };
    return snapped(x, y, endsOf(now, but), scaleOf(painter.camera));
  };

  const onPointerDown = (event: PointerEvent<HTMLDivElement>) => {
    if (event.button !== 0 || !event.isPrimary) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    event.currentTarget.focus();
    event.preventDefault();
    const at = spot(event);
    const [x, y] = [event.clientX, event.clientY];
    if (own === null) {
      drag.current = { what: "pan", x, y, moved: false };
      return;
    }
    if (tool !== null) {
      drag.current = { what: "new", tool, from: snap(event, at, []), x, y, began: own };
      return;
    }
    const grip = (event.target as Element).getAttribute("data-grip");
    const [held] = chosenIn(own, chosen);
    if (grip !== null && held !== undefined) {
      drag.current = { what: "grip", thing: held, grip, began: own };
      return;
    }
    const found = painter === null ? null : thingAt(own, at.x, at.y, scaleOf(painter.camera));
    if (found === null) {
      drag.current = { what: "pan", x, y, moved: false };
      return;
    }
    const also = event.ctrlKey || event.metaKey || event.shiftKey;
    const there = chosen.some((one) => isSamePart(one, found));
    const things = also
      ? there
        ? chosen.filter((one) => !isSamePart(one, found))
        : [found, ...chosen]
      : there
        ? chosen
        : [found];
    choose(things);
    drag.current = { what: "move", from: at, x, y, held: false, began: own, things };
  };

  const onPointerMove = (event: PointerEvent) => {
    const held = drag.current;
    if (held === null) return;
    const at = spot(event);
    switch (held.what) {
      case "pan": {
        const [dx, dy] = [event.clientX - held.x, event.clientY - held.y];
        if (!held.moved && Math.hypot(dx, dy) < CLICK_PX) return;
        painter?.pan(dx, dy);
        drag.current = { ...held, x: event.clientX, y: event.clientY, moved: true };
        return;
      }
      case "grip": {
        const to = held.grip.startsWith("cut") ? at : snap(event, at, [held.thing]);
        setDraft(dragged(held.began, held.thing, held.grip, to.x, to.y));
        return;
      }
      case "move": {
        const far = Math.hypot(event.clientX - held.x, event.clientY - held.y);
        if (!held.held && far < CLICK_PX) return;
        held.held = true;
        const [first] = held.things;
        const anchor = first === undefined ? null : anchorOf(held.began, first);
        if (anchor === null) return;
        const wanted = { x: anchor.x + at.x - held.from.x, y: anchor.y + at.y - held.from.y };
        const to = first?.kind === "dock" ? wanted : snap(event, wanted, held.things);
        const [dx, dy] = [to.x - anchor.x, to.y - anchor.y];
        setDraft(held.things.reduce((one, thing) => moved(one, thing, dx, dy), held.began));
        return;
      }
      case "new": {
        if (Math.hypot(event.clientX - held.x, event.clientY - held.y) < CLICK_PX) return;
        const to = snap(event, at, []);
        const from = held.tool === "start" || held.tool === "dock" ? to : held.from;
        setDraft(drawNew(held.began, held.tool, from, to)?.world ?? null);
      }
    }
  };

  const onPointerUp = (event: PointerEvent) => {
    const held = drag.current;
    drag.current = null;
    if (held === null) return;
    const made = useWorld.getState().draft;
    setDraft(null);
    if (held.what === "pan") {
      if (!held.moved) choose([]);
    } else if (held.what === "new") {
      const drawn = Math.hypot(event.clientX - held.x, event.clientY - held.y) >= CLICK_PX;
      const to = drawn ? snap(event, spot(event), []) : null;
      put(held.tool, to !== null && (held.tool === "start" || held.tool === "dock") ? to : held.from, to);
    } else if (made !== null) {
      const [name, key] =
        held.what === "move"
          ? [called(held.began, held.things), "command.move" as const]
          : [nameOf(held.began, held.thing), "command.edit" as const];
      change(t(key, { name }), made);
    }
  };

  const stop = () => {
    const busy = drag.current !== null || tool !== null;
    drag.current = null;
    putDown();
    if (!busy) choose([]);
  };

  const walk = (by: 1 | -1) => {
    const things = own === null ? [] : partReferences(own);
    const [first] = chosen;
    const at = first === undefined ? -1 : things.findIndex((one) => isSamePart(one, first));
    const next = things[(at < 0 ? (by > 0 ? 0 : things.length - 1) : at + by + things.length) % things.length];
    if (next !== undefined) choose([next]);
  };

  const onKeyDown = (event: KeyboardEvent) => {
    const id = keyIn(WORLD_KEYS, event.nativeEvent);
    if (id === null) return;
    const held = chosenIn(own, chosen).length > 0;
    const shift = (x: number, y: number) => {
      const step = event.shiftKey ? 10 : 1;
      if (held) nudge(x * step, y * step);
      else painter?.pan(-x * PAN_PX, y * PAN_PX);
    };
    const acts: Record<keyof typeof WORLD_KEYS, () => void> = {
      left: () => shift(-1, 0),
      right: () => shift(1, 0),
      up: () => shift(0, 1),
      down: () => shift(0, -1),
      remove: removeChosen,
      duplicate: duplicateChosen,
      all: () => choose(own === null ? [] : partReferences(own)),
      stop,
      next: () => walk(1),
      previous: () => walk(-1),
      zoomIn: () => painter?.zoom(1.4),
      zoomOut: () => painter?.zoom(1 / 1.4),
      fit: () => painter?.showAll(),
    };
    event.preventDefault();
    event.stopPropagation();
    acts[id]();
  };

  const counts = now === null ? "" : [...new Set(partReferences(now).map((thing) => nameOf(now, thing)))].join(", ");
  return (
    <div
      className="world-stage fill focus-inside relative"
      role="application"
      dir="ltr"
      tabIndex={0}
      data-testid="world-stage"
      data-tool={tool ?? "none"}
      aria-label={t("world.stage")}
      aria-describedby="world-summary"
      ref={frame}
      onKeyDown={onKeyDown}
      onPointerDown={onPointerDown}
      onPointerMove={onPointerMove}
      onPointerUp={onPointerUp}
      onPointerCancel={() => {
        drag.current = null;
        setDraft(null);
      }}
    >
      <canvas ref={canvas} aria-hidden="true" />
      {now === null || camera === null ? null : (
        <Overlay world={now} camera={camera} chosen={chosenIn(now, chosen)} mission={mission} />
      )}
      {tool === null ? null : (
        <p className="world-tip row small-text gap-s boxed passive" aria-hidden="true">
          <Icon name={KIND_ICONS[tool]} size={14} /> {t(handKey("world.draw"), { kind: kindName(tool) })}
        </p>
      )}
      <p className="only-spoken" id="world-summary">
        {counts}
      </p>
    </div>
  );
}
