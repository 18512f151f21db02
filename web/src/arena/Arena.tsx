/** The place where the robots are: before a run as the mission starts, during a run as it goes. */
import { type KeyboardEvent, type PointerEvent, useEffect, useMemo, useRef, useState } from "react";

import { useStudio } from "../model/studio";
import { ARENA_KEYS, keyIn } from "../reach/key-table";
import { posesAt, watchFrames } from "../run/poses";
import { useRun } from "../run/run";
import { Seed } from "../run/Seed";
import { Icon, useTheme } from "../theme";
import { decimal } from "../words/numbers";
import { t } from "../words/words";
import "./arena.css";
import { EmptyArena } from "./EmptyArena";
import { Painter } from "./painter";
import { lookAt, type Scene, sceneBefore, sceneOf } from "./scene";
import { summary } from "./summary";

const CLICK_PX = 4;
/** One press of an arrow key. */
const PAN_PX = 40;
const SPOKEN_MS = 250;

function useScene(): Scene | null {
  const run = useRun();
  const mission = useStudio((studio) => studio.mission);
  const catalogue = useStudio((studio) => studio.catalogue);
  const ownWorld = useStudio((studio) => studio.world);
  const before = useMemo(() => (ownWorld === null ? null : sceneBefore(mission, ownWorld)), [mission, ownWorld]);
  return useMemo(
    () => (run.world !== null && run.agents.length > 0 ? sceneOf(run, mission, catalogue, run.world) : before),
    [run, mission, catalogue, before],
  );
}

/** Who wears the ring: the agent watched in the program that is open. */
function useSelected(scene: Scene | null): string {
  const program = useStudio((studio) => studio.activeProgram);
  const chosen = useRun((run) => run.selectedAgent[program]);
  const own = scene?.actors.filter((actor) => actor.program === program) ?? [];
  return (own.find((actor) => actor.name === chosen) ?? own[0])?.name ?? "";
}

/** The scene in words, renewed a few times a second at most. */
function useSummary(scene: Scene | null): string {
  const words = () => {
    if (scene === null) return "";
    const shown = scene.running ? posesAt(performance.now(), false) : null;
    return summary(scene, lookAt(scene, shown?.poses ?? null));
  };
  const [spoken, setSpoken] = useState("");
  const latest = useRef(words);
  useEffect(() => {
    latest.current = words;
  });
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const renew = () => {
      timer ??= setTimeout(() => {
        timer = undefined;
        setSpoken(latest.current());
      }, SPOKEN_MS);
    };
    setSpoken(latest.current());
    const off = watchFrames(renew);
    const offRun = useRun.subscribe(renew);
    const offStudio = useStudio.subscribe(renew);
    return () => {
      clearTimeout(timer);
      off();
      offRun();
      offStudio();
    };
  }, []);
  return spoken;
}

function Heading({ scene, painter }: { scene: Scene | null; painter: Painter | null }) {
  const world = scene?.world;
  const size = (mm: number) => decimal(mm / 1000);
  const what =
    world === undefined
      ? ""
      : world.roads.length > 0
        ? world.name
        : `${world.name} · ${t("arena.size", { width: size(world.width_mm), height: size(world.height_mm) })}`;
  const tools: [string, string, () => void][] = [
    ["zoom-out", t("arena.zoom-out"), () => painter?.zoom(1 / 1.4)],
    ["zoom-in", t("arena.zoom-in"), () => painter?.zoom(1.4)],
    ["maximize", t("arena.fit"), () => painter?.showAll()],
  ];
  return (
    <header className="side-head">
      <h2>{t("arena.title")}</h2>
      <span className="side-note">{what}</span>
      {world === undefined ? null : <Seed />}
      <span className="side-tools">
        {tools.map(([icon, label, act]) => (
          <button key={icon} type="button" className="tool small" aria-label={label} title={label} onClick={act}>
            <Icon name={icon} size={16} />
          </button>
        ))}
      </span>
    </header>
  );
}

/** Opens the program of a robot and watches that robot. */
function choose({ name, program }: { name: string; program: string }): void {
  useStudio.getState().setActiveProgram(program);
  useRun.getState().selectAgent(name, program);
}

export function Arena() {
  const scene = useScene();
  const selected = useSelected(scene);
  const spoken = useSummary(scene);
  const theme = useTheme((state) => state.theme);
  const frame = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [painter, setPainter] = useState<Painter | null>(null);
  const grip = useRef<{ x: number; y: number; moved: boolean } | null>(null);

  useEffect(() => {
    const [box, drawn] = [frame.current, canvas.current];
    if (box === null || drawn === null) return;
    const still = matchMedia("(prefers-reduced-motion: reduce)");
    const made = new Painter(drawn, () => !still.matches);
    setPainter(made);
    const watcher = new ResizeObserver(([entry]) => {
      if (entry !== undefined) made.resize(entry.contentRect.width, entry.contentRect.height);
    });
    watcher.observe(box);
    const offFrames = watchFrames(() => made.paintSoon());
    // A wheel listener that may prevent scrolling cannot be passive, as React's are.
    const onWheel = (event: WheelEvent) => {
      event.preventDefault();
      const place = drawn.getBoundingClientRect();
      made.zoom(Math.exp(-event.deltaY * 0.0015), event.clientX - place.left, event.clientY - place.top);
    };
    drawn.addEventListener("wheel", onWheel, { passive: false });
    void document.fonts?.ready.then(() => made.paintSoon());
    return () => {
      watcher.disconnect();
      offFrames();
      drawn.removeEventListener("wheel", onWheel);
      made.end();
    };
  }, []);
  useEffect(() => {
    if (scene !== null) painter?.setScene(scene, selected);
  }, [painter, scene, selected]);
  useEffect(() => {
    painter?.themeChanged();
  }, [painter, theme]);

  const onPointerDown = (event: PointerEvent<HTMLCanvasElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    grip.current = { x: event.clientX, y: event.clientY, moved: false };
  };
  const onPointerMove = (event: PointerEvent) => {
    const held = grip.current;
    if (held === null) return;
    const [dx, dy] = [event.clientX - held.x, event.clientY - held.y];
    if (!held.moved && Math.hypot(dx, dy) < CLICK_PX) return;
    painter?.pan(dx, dy);
    grip.current = { x: event.clientX, y: event.clientY, moved: true };
  };
  const onPointerUp = (event: PointerEvent<HTMLCanvasElement>) => {
    const held = grip.current;
    grip.current = null;
    if (held === null || held.moved) return;
    const place = event.currentTarget.getBoundingClientRect();
    const found = painter?.actorAt(event.clientX - place.left, event.clientY - place.top);
    if (found === null || found === undefined) return;
    choose(found.actor);
  };
  const next = (by: 1 | -1) => {
    const actors = scene?.actors ?? [];
    const at = actors.findIndex((actor) => actor.name === selected);
    const actor = actors[(at + by + actors.length) % Math.max(1, actors.length)];
    if (actor !== undefined) choose(actor);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const id = keyIn(ARENA_KEYS, event.nativeEvent);
    if (id === null) return;
    event.preventDefault();
    event.stopPropagation();
    const acts: Record<keyof typeof ARENA_KEYS, () => void> = {
      left: () => painter?.pan(PAN_PX, 0),
      right: () => painter?.pan(-PAN_PX, 0),
      up: () => painter?.pan(0, PAN_PX),
      down: () => painter?.pan(0, -PAN_PX),
      zoomIn: () => painter?.zoom(1.4),
      zoomOut: () => painter?.zoom(1 / 1.4),
      fit: () => painter?.showAll(),
      next: () => next(1),
      previous: () => next(-1),
    };
    acts[id]();
  };

  return (
    <div className="arena" data-testid="arena">
      <Heading scene={scene} painter={painter} />
      <div className="arena-frame" ref={frame}>
        <canvas
          ref={canvas}
          role="application"
          tabIndex={0}
          data-testid="arena-canvas"
          aria-label={t("arena.label")}
          aria-describedby="arena-summary"
          onKeyDown={onKeyDown}
          onPointerDown={onPointerDown}
          onPointerMove={onPointerMove}
          onPointerUp={onPointerUp}
          onPointerCancel={() => {
            grip.current = null;
          }}
        />
        <EmptyArena scene={scene} />
      </div>
      <p className="only-spoken" id="arena-summary" data-testid="arena-summary">
        {spoken}
      </p>
    </div>
  );
}
