/** Under the small program: the robot that is watched, its picture and what it senses and shows now. */
import { useEffect, useRef } from "react";

import { looksOf } from "../../../components/scene/draw-robots";
import { drawFigure } from "../../../components/scene/figures";
import { indicatorsOf } from "../../../components/scene/boards";
import { readColours } from "../../../components/scene/colours";
import type { Actor } from "../../../components/scene/scene";
import { decimal } from "../../../i18n/numbers";
import { t } from "../../../i18n/words";
import { text } from "../../../model/texts";
import { valueWords } from "../../../model/words";
import type { Robot } from "../../../model/types";
import { useStudio } from "../../../model/studio";
import { FAILED, LAMP } from "../../../api/wire";
import { posesAt, watchFrames } from "../../../session/poses";
import { type RunAgent, useRun } from "../../../session/run";
import { useView } from "../../../session/view";
import { Icon, useTheme } from "../../../theme";
import { useScene, useSelected } from "../use-scene";

const PORTRAIT_PX = 56;

/** "77", "yes", "34.5 cm": what a sensor reads, in the words of its robot. */
export function reading(robot: Robot | undefined, name: string, value: number): string {
  const part = robot?.objects.find((one) => one.name === name && one.category === "sensor");
  if (part !== undefined && (part.meaning != null || part.unit))
    return `${part.ray != null && value >= part.max ? "≥ " : ""}${valueWords(part, value)}`;
  if (part?.type === "boolean") return t(value === 0 ? "arena.no" : "arena.yes");
  if (part?.ray != null && part.max > part.min) {
    const mm = ((value - part.min) / (part.max - part.min)) * part.ray.reach_mm;
    return `${value >= part.max ? "≥ " : ""}${decimal(Math.round(mm) / 10)} cm`;
  }
  return String(value);
}

export function RobotReadings() {
  const scene = useScene();
  const selected = useSelected(scene);
  const actor = scene?.actors.find(({ name }) => name === selected);
  const program = useStudio((studio) => studio.activeProgram);
  const agent = useRun((run) => run.agents.find(({ name }) => name === selected));
  const catalogue = useStudio((studio) => studio.catalogue);
  const missionRobot = useStudio(
    (studio) => studio.mission.programs.find(({ name }) => name === actor?.program)?.robot,
  );
  // Another program is shown whole, too.
  useEffect(() => {
    const soon = requestAnimationFrame(() => useView.getState().viewport?.whole());
    return () => cancelAnimationFrame(soon);
  }, [program]);
  if (actor === undefined) return null;
  const robot = catalogue.robots.find(({ name }) => name === (agent?.robot ?? missionRobot));
  return (
    <section className="stage-watched rigid flex" aria-label={t("arena.watched")} data-testid="stage-watched">
      <Portrait actor={actor} />
      <div>
        <h2 className="panel-title">
          {actor.name} <small>{text(robot?.label ?? {}, robot?.name ?? "")}</small>
        </h2>
        <Readings robot={robot} agent={agent} />
      </div>
    </section>
  );
}

function Readings({ robot, agent }: { robot: Robot | undefined; agent: RunAgent | undefined }) {
  if (agent === undefined) return <p className="muted small-text">{t("arena.no-readings")}</p>;
  const sensors = (robot?.objects ?? []).filter(({ name, category }) => category === "sensor" && name in agent.inputs);
  const shown = indicatorsOf(robot, agent.shown);
  return (
    <dl>
      {sensors.slice(0, 6).map(({ name, icon, label }) => (
        <div key={name}>
          <dt>
            <Icon name={icon} size={14} />
            {text(label, name)}
          </dt>
          <dd>{reading(robot, name, agent.inputs[name] ?? 0)}</dd>
        </div>
      ))}
      {shown.slice(0, 3).map(({ label, value }) => (
        <div key={label}>
          <dt>{label}</dt>
          <dd>{String(value)}</dd>
        </div>
      ))}
    </dl>
  );
}

/** The robot's figure, looking up; drawn anew when its lamp or its state changes. */
function Portrait({ actor }: { actor: Actor }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const theme = useTheme((state) => state.theme);
  const { name } = actor;
  useEffect(() => {
    let before = "";
    const draw = () => {
      const pen = canvas.current?.getContext("2d");
      const index = useRun.getState().agents.findIndex((agent) => agent.name === name);
      const pose = posesAt(0, false)?.poses[index] ?? actor.start;
      const failed = actor.failed || (pose.flags & FAILED) !== 0;
      const now = `${String(pose.flags & LAMP)} ${String(pose.load)} ${String(failed)}`;
      if (pen == null || now === before) return;
      before = now;
      const ratio = window.devicePixelRatio || 1;
      const [size, u] = [PORTRAIT_PX * ratio, (PORTRAIT_PX * ratio) / 64];
      pen.canvas.width = size;
      pen.canvas.height = size;
      pen.translate(size / 2, size / 2);
      const seen = { actor, pose, failed, stalled: false, muted: false, collided: false };
      if (actor.figure !== "store-manager") pen.rotate(-Math.PI / 2);
      drawFigure(pen, u, looksOf(seen), readColours());
    };
    draw();
    return watchFrames(draw);
    // The actor is made anew with each message of the run.
    // eslint-disable-next-line react-hooks/exhaustive-deps
  }, [name, theme, actor.figure, actor.lid]);
  return <canvas ref={canvas} className="stage-portrait rigid boxed" aria-hidden="true" />;
}
