/** The robots that take part: name, program and start of each; added, copied, moved and removed. */
import { type KeyboardEvent, useRef } from "react";

import { NameCell } from "../../components/NameCell";
import { t } from "../../i18n/words";
import { giveKind } from "../../model/commands/castAgents";
import {
  addAgent,
  copyAgent,
  giveProgram,
  giveStart,
  moveAgent,
  placeAgents,
  removeAgent,
  renameAgent,
} from "../../model/commands/changeAgents";
import { freeName } from "../../model/free-name";
import { startOf } from "../../model/starts";
import { execute, useStudio } from "../../model/studio";
import { TEAM_ROBOT } from "../../model/team-robot";
import { text } from "../../model/texts";
import type { Agent, Mission, World } from "../../model/types";
import type { addStarting } from "../../session/world-edits";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { Select } from "../../ui/Select";
import { Tool } from "../../ui/Tool";

/** Why a robot cannot have that name, or "". */
function wrongName(name: string): string {
  if (name === "") return t("team.name-empty");
  const taken = useStudio.getState().mission.agents.some((agent) => agent.name === name);
  return taken ? t("team.name-taken", { name }) : "";
}

/** A robot like the last one with that program, at a start of its own where the world has room for one. */
async function newAgent(): Promise<void> {
  const { mission, activeProgram } = useStudio.getState();
  const last = mission.agents.findLast(({ program }) => program === activeProgram) ?? mission.agents.at(-1);
  const names = mission.agents.map((agent) => agent.name);
  await atStart(last === undefined ? "" : startOf(last), (before, start, isFree) => {
    const name = isFree && !names.includes(start) ? start : nameLike(last?.name ?? "robot", names);
    return addAgent(before, name, activeProgram, start);
  });
}

async function duplicate(at: number): Promise<void> {
  const { mission } = useStudio.getState();
  const agent = mission.agents[at];
  if (agent === undefined) return;
  const names = mission.agents.map((one) => one.name);
  await atStart(startOf(agent), (before, start) => copyAgent(before, at, nameLike(agent.name, names), start));
}

/** One more robot near the start `beside`; without a world, or room in it, at that start itself. */
async function atStart(beside: string, add: Parameters<typeof addStarting>[1]): Promise<void> {
  const { addStarting } = await import("../../session/world-edits");
  if (useStudio.getState().world !== null && (await addStarting(beside, add))) return;
  execute(add(useStudio.getState().mission, beside, false));
}

interface RowProps {
  agent: Agent;
  at: number;
  onKey: (event: KeyboardEvent, at: number) => void;
  focus: (at: number, what: string) => void;
}

function Row({ agent, at, onKey, focus }: RowProps) {
  const programs = useStudio((studio) => studio.mission.programs);
  const agents = useStudio((studio) => studio.mission.agents);
  const robots = useStudio((studio) => studio.catalogue.robots);
  const world = useStudio((studio) => studio.world);
  const { name, program } = agent;
  const start = startOf(agent);
  const starts = world?.starts.map((one) => one.name) ?? [];
  const lost = world !== null && !starts.includes(start);
  const others = new Set(agents.filter((one) => one !== agent).map(startOf));
  const now = () => useStudio.getState().mission;
  const tools: [string, string, string, boolean, () => void][] = [
    ["copy", "copy", t("team.duplicate", { name }), false, () => void duplicate(at)],
    ["up", "arrow-up", t("team.up", { name }), at === 0, () => move(-1)],
    ["down", "arrow-down", t("team.down", { name }), at === agents.length - 1, () => move(1)],
    ["remove", "trash-2", t("team.remove", { name }), false, remove],
  ];
  function move(by: number) {
    if (execute(moveAgent(now(), at, at + by))) focus(at + by, by < 0 ? "up" : "down");
  }
  function remove() {
    if (execute(removeAgent(now(), at))) focus(Math.min(at, agents.length - 2), "remove");
  }
  return (
    <li
      className="team-row team-agent gap-m"
      data-testid={`agent-${String(at)}`}
      data-name={name}
      onKeyDown={(event) => onKey(event, at)}
    >
      <NameCell
        name={name}
        label={`${t("team.agent")} ${String(at + 1)}`}
        testId={`agent-name-${String(at)}`}
        wrong={wrongName}
        keep={(wanted) => execute(renameAgent(now(), at, wanted, useStudio.getState().catalogue))}
      />
      <span className="column gap-xs">
        <Select
          label={`${t("team.program")}: ${name}`}
          testId={`agent-program-${String(at)}`}
          value={program}
          options={programs.filter((one) => one.level !== "group" || one.name === program).map((one) => one.name)}
          missing={t("team.no-program", { program })}
          keep={(wanted) => execute(giveProgram(now(), at, wanted))}
        />
        {programs.some((one) => one.name === program && one.robot === TEAM_ROBOT) ? (
          <Select
            label={`${t("roster.robot")}: ${name}`}
            testId={`agent-robot-${String(at)}`}
            value={agent.robot ?? ""}
            options={robots
              .filter((one) => one.name !== TEAM_ROBOT)
              .map((one) => [one.name, text(one.label, one.name)])}
            missing={t("roster.no-robot", { robot: agent.robot ?? "" })}
            keep={(wanted) => execute(giveKind(now(), at, wanted))}
          />
        ) : null}
      </span>
      <Select
        label={`${t("team.start")}: ${name}`}
        testId={`agent-start-${String(at)}`}
        value={start}
        options={starts.map((one) => [one, others.has(one) ? t("team.start-taken", { start: one }) : one])}
        missing={lost ? t("team.no-start", { start }) : start}
        wrong={lost}
        keep={(wanted) => execute(giveStart(now(), at, wanted))}
      />
      <span className="team-tools aligned">
        {tools.map(([what, icon, label, disabled, act]) => (
          <Tool
            key={what}
            small
            icon={icon}
            label={label}
            testId={`agent-${what}-${String(at)}`}
            data-what={what}
            aria-disabled={disabled}
            onClick={() => {
              if (!disabled) act();
            }}
          />
        ))}
      </span>
    </li>
  );
}

export function Agents() {
  const mission = useStudio((studio) => studio.mission);
  const world = useStudio((studio) => studio.world);
  const list = useRef<HTMLUListElement>(null);
  const button = useRef<HTMLButtonElement>(null);
  const { agents } = mission;
  const lost = withoutStart(mission, world).length;
  const place =
    world === null
      ? null
      : placeAgents(
          mission,
          world.starts.map((start) => start.name),
        );

  const focus = (at: number, what: string) => {
    requestAnimationFrame(() => {
      const row = list.current?.children[at];
      const found = row?.querySelector<HTMLElement>(`[data-what="${what}"]`) ?? button.current;
      found?.focus();
    });
  };
  const onKey = (event: KeyboardEvent, at: number) => {
    if (!event.altKey || (event.key !== "ArrowUp" && event.key !== "ArrowDown")) return;
    event.preventDefault();
    const by = event.key === "ArrowUp" ? -1 : 1;
    const field = (event.target as HTMLElement).dataset["testid"]?.replace(/\d+$/, String(at + by));
    if (!execute(moveAgent(useStudio.getState().mission, at, at + by)) || field === undefined) return;
    requestAnimationFrame(() => list.current?.querySelector<HTMLElement>(`[data-testid="${field}"]`)?.focus());
  };

  return (
    <section className="team-part surface" aria-labelledby="team-agents">
      <h2 id="team-agents">{t("team.agents")}</h2>
      {agents.length === 0 ? (
        <p className="team-note muted">{t("team.agents-none")}</p>
      ) : (
        <>
          <div className="team-row team-agent team-heads muted small-text gap-m" aria-hidden="true">
            <span>{t("team.agent")}</span>
            <span>{t("team.program")}</span>
            <span>{t("team.start")}</span>
          </div>
          <ul ref={list}>
            {agents.map((agent, at) => (
              <Row key={at} agent={agent} at={at} onKey={onKey} focus={focus} />
            ))}
          </ul>
        </>
      )}
      {lost > 0 ? (
        <p className="team-note row wrap" role="status">
          <Icon name="triangle-alert" size={16} /> {t("team.place-help", { count: lost })}{" "}
          {place === null ? null : (
            <Button testId="place-agents" onClick={() => execute(place)}>
              {t("team.place")}
            </Button>
          )}
        </p>
      ) : null}
      <Button
        icon="plus"

        ref={button}
        testId="add-agent"
        onClick={() => {
          void newAgent().then(() =>
            requestAnimationFrame(() => {
              const field = list.current?.lastElementChild?.querySelector<HTMLInputElement>("input");
              field?.focus();
              field?.select();
            }),
          );
        }}
      >
        {" "}
        {t("team.add-agent")}
      </Button>
    </section>
  );
}

/** The agents whose start the world has not, by their place in the list. */
function withoutStart(mission: Mission, world: World | null): number[] {
  if (world === null) return [];
  const known = new Set(world.starts.map((start) => start.name));
  return mission.agents.flatMap((agent, at) => (known.has(startOf(agent)) ? [] : [at]));
}

/** A free name like the given one: `carrier-1` gives `carrier-2`. */
function nameLike(name: string, taken: readonly string[]): string {
  const stem = name.replace(/[-\s]?\d+$/, "");
  return freeName(stem === "" ? "robot" : stem, taken);
}
