/** The place where the robots are: before a run as the mission starts, during a run as it goes. */
import "./arena.css";

import { type KeyboardEvent, useEffect, useRef, useState } from "react";

import { CROWD } from "../../components/scene/crowd-size";
import { Painter } from "../../components/scene/painter";
import type { Actor, Scene } from "../../components/scene/scene";
import { decimal } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { namesPart } from "../../model/named-parts";
import { useStudio } from "../../model/studio";
import { KIND_ICONS } from "../../model/world/names";
import { reportError } from "../../session/document";
import { keyFor, keyIn } from "../../session/key-table";
import { watchFrames } from "../../session/poses";
import { isEnded, useRun } from "../../session/run";
import { useShown } from "../../session/simple-view";
import { toggleText, useStage } from "../../session/stage";
import { openWorldWith } from "../../session/world-view";
import { useTheme } from "../../theme";
import { endAll } from "../../ui/effects";
import { later } from "../../ui/later";
import { Tool } from "../../ui/Tool";
import { EmptyArena } from "./EmptyArena";
import { ARENA_KEYS, PAGE_KEYS } from "./keys";
import { openShown, toggleStage, useStageParts } from "./parts";
import { choose, follow, openRobotMenu, useRobots } from "./robots";
import { Seed } from "./Seed";
import { useArenaPointer } from "./use-arena-pointer";
import { useScene, useSelected, useSummary } from "./use-scene";

const RobotMenu = later(() => import("./RobotMenu").then((chunk) => chunk.RobotMenu), reportError);
const Crowd = later(() => import("./Crowd").then((chunk) => chunk.Crowd), reportError);
const Hands = later(() => import("./Hands").then((chunk) => chunk.Hands), reportError);

const PartPlacement = later(() => import("./PartPlacement").then((chunk) => chunk.PartPlacement), reportError);

/** One press of an arrow key. */
const PAN_PX = 40;
interface HeadingProps {
  scene: Scene | null;
  painter: Painter | null;
  stage: ReturnType<typeof useStageParts>;
}

function Heading({ scene, painter, stage }: HeadingProps) {
  const { large, beside, text } = useStage();
  const seed = useShown("seed");
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
    <header className="side-head row rigid">
      <h2 className="panel-title">{t("arena.title")}</h2>
      <span className="side-note ellipsis muted small-text" title={what}>
        {what}
      </span>
      {world === undefined || !seed ? null : <Seed />}
      {large && stage !== null ? <stage.Switches /> : null}
      {large || scene === null || scene.running || isDesk(scene) ? null : <Additions />}
      <span className="side-tools flex to-end">
        {large ? null : (
          <Tool
            small
            icon="eye"
            label={t("arena.show")}
            testId="arena-show"
            aria-haspopup="menu"
            onClick={({ currentTarget }) => {
              const { left, bottom } = currentTarget.getBoundingClientRect();
              openShown(left, bottom + 4);
            }}
          />
        )}
        {(beside || text) && !large ? (
          <Tool
            small
            icon="file"
            label={t("arena.text")}
            testId="arena-text"
            aria-pressed={text}
            data-wide="true"
            onClick={toggleText}
          />
        ) : null}
        {tools.map(([icon, label, act]) => (
          <Tool key={icon} small icon={icon} label={label} data-zoom={icon.startsWith("zoom")} onClick={act} />
        ))}
        <Tool
          small
          icon="maximize-2"
          label={t("arena.large")}
          keys={keyFor.page(PAGE_KEYS.stage)}
          testId="arena-large"
          aria-pressed={large}
          onClick={toggleStage}
        />
      </span>
    </header>
  );
}

/** Whether boards lie there that go nowhere: nothing in a world is of use to them. */
function isDesk({ actors }: Scene): boolean {
  return actors.length > 0 && actors.every(({ figure }) => figure === "micro-bit");
}

/** What is most often put into a world; each leads into the world with its tool in hand. */
const ADDED = ["wall", "ball", "start"] as const;

function Additions() {
  return (
    <span className="side-tools side-additions flex to-end">
      {ADDED.map((kind) => (
        <Tool
          key={kind}
          small
          icon={KIND_ICONS[kind]}
          label={t(`arena.add-${kind}`)}
          testId={`arena-add-${kind}`}
          onClick={() => openWorldWith(kind)}
        />
      ))}
    </span>
  );
}

export function Arena() {
  const scene = useScene();
  const selected = useSelected(scene);
  const spoken = useSummary(scene);
  const theme = useTheme((state) => state.theme);
  const frame = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [painter, setPainter] = useState<Painter | null>(null);
  const [near, setNear] = useState(false);
  const { program, followed } = useRobots();
  const menu = useRobots((state) => state.menu !== null);
  const stage = useStageParts();
  const name = useRun((run) => run.name);
  const over = useRun((run) => isEnded(run.status));

  useEffect(() => {
    const [box, drawn] = [frame.current, canvas.current];
    if (box === null || drawn === null) return;
    const still = matchMedia("(prefers-reduced-motion: reduce)");
    const made = new Painter(
      drawn,
      () => !still.matches,
      ({ scale, x, y }) => {
        drawn.dataset["camera"] = [scale, x, y].join(" ");
      },
    );
    setPainter(made);
    return endAll(
      watchFrames(() => made.paintSoon()),
      made.attachTo(box, drawn),
    );
  }, []);
  useEffect(() => {
    if (scene !== null) painter?.setScene(scene, selected);
  }, [painter, scene, selected]);
  const places = useShown("places");
  useEffect(() => {
    // Once the parts of the stage are there, they say what is shown.
    if (stage === null) painter?.setLayers({ place: places, names: false }, null);
  }, [painter, stage, places]);
  useEffect(() => {
    painter?.setView(program, followed);
  }, [painter, program, followed]);
  useEffect(() => {
    painter?.setOpen(!over);
  }, [painter, name, over, stage]);
  useEffect(() => {
    painter?.themeChanged();
  }, [painter, theme]);

  const pointer = useArenaPointer(canvas, painter, scene);
  /** The menu of the robot that wears the ring, beside it. */
  const menuOfSelected = () => {
    const place = canvas.current?.getBoundingClientRect();
    const at = painter?.placeOf(selected);
    if (place === undefined || at === null || at === undefined) return;
    const inside = (value: number, most: number) => Math.min(Math.max(value, 0), most);
    openRobotMenu(selected, place.left + inside(at[0], place.width), place.top + inside(at[1], place.height));
  };
  const next = (by: 1 | -1) => {
    const actors = scene?.actors ?? [];
    const at = actors.findIndex((actor) => actor.name === selected);
    const actor = actors[(at + by + actors.length) % Math.max(1, actors.length)];
    if (actor !== undefined) choose(actor);
  };
  const watched = scene?.actors.find((actor) => actor.name === selected);
  /** The key of the watched robot that a key of the keyboard holds. */
  const keyOf = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) return undefined;
    const letters = [event.key.toUpperCase(), event.code.replace(/^Key/, "")];
    return watched?.keys.find(({ letter }) => letter !== "" && letters.includes(letter));
  };
  const onKeyUp = (event: KeyboardEvent) => {
    const key = keyOf(event);
    if (key !== undefined) painter?.boards?.release(selected, key.sensor);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const key = keyOf(event);
    if (key !== undefined && (event.repeat || painter?.boards?.press(selected, key.sensor) === true)) {
      event.preventDefault();
      event.stopPropagation();
      return;
    }
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
      menu: menuOfSelected,
      follow: () => follow(selected),
      hand: () => undefined,
      take: () => undefined,
    };
    acts[id]();
  };

  return (
    <div className="arena column" data-testid="arena">
      <Heading scene={scene} painter={painter} stage={stage} />
      {scene !== null && scene.actors.length >= CROWD ? <Crowd scene={scene} /> : null}
      <div className="arena-frame fill relative" ref={frame}>
        <canvas
          ref={canvas}
          role="application"
          tabIndex={0}
          data-testid="arena-canvas"
          aria-label={t("arena.label")}
          aria-describedby="arena-summary"
          onKeyDown={onKeyDown}
          onKeyUp={onKeyUp}
          onFocus={() => setNear(true)}
          onPointerEnter={() => setNear(true)}
          onBlur={() => painter?.boards?.releaseAll()}
          onDoubleClick={() => painter?.showSubject()}
          {...pointer}
        />
        <EmptyArena scene={scene} />
        {near && painter !== null && scene?.running === false ? (
          <PartPlacement painter={painter} canvas={canvas} selected={selected} />
        ) : null}
        {stage === null || painter === null ? null : (
          <stage.Shown scene={scene} selected={selected} painter={painter} />
        )}
      </div>
      {stage === null || painter === null ? null : (
        <div className="rigid relative">
          <stage.EndCard painter={painter} />
        </div>
      )}
      {watched === undefined ? null : <HandsOf agent={watched} />}
      <p className="only-spoken" id="arena-summary" data-testid="arena-summary">
        {spoken}
      </p>
      <Said />
      {menu ? <RobotMenu onClosed={() => canvas.current?.focus()} /> : null}
    </div>
  );
}

/** What can be worked on a robot, of what its program asks; the board in the picture has all of it. */
function HandsOf({ agent: { name, keys, sliders } }: { agent: Pick<Actor, "name" | "keys" | "sliders"> }) {
  const mission = useStudio((studio) => studio.mission);
  const program = mission.agents.find((agent) => agent.name === name)?.program ?? "";
  const isAsked = ({ sensor }: { sensor: string }) => namesPart(mission, program, sensor);
  const asked = { keys: keys.filter(isAsked), sliders: sliders.filter(isAsked) };
  return asked.keys.length + asked.sliders.length === 0 ? null : <Hands agent={name} {...asked} />;
}

/** Announces the chosen robot, and faults of robots (`StatesSaid`), to screen readers. */
function Said() {
  const said = useRobots((state) => state.said);
  return (
    <p className="only-spoken" aria-live="polite" data-testid="states-said">
      {said}
    </p>
  );
}
