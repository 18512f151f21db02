/**
 * The programs of the mission as tabs, then what runs in the one that is open.
 *
 * Each tab shows how many agents run its program and, during a run, the state of the one that is watched. Programs without
 * room are in a list behind their row; team and world stand behind it and keep their place. At the end of the row: what runs
 * in the program (`Running`).
 */
import { type KeyboardEvent, useCallback, useEffect, useRef, useState } from "react";

import type { AgentActivity } from "../api/wire";
import { renameProgram } from "../model/commands/changePrograms";
import { useStudio } from "../model/studio";
import { isLive, type RunState, useRun, watchedAgent } from "../run/run";
import { Icon } from "../theme";
import { closeTeam, openTeam, showWorld, useTeam } from "../team/view";
import { TeamTab } from "../team/TeamTab";
import { WorldTab } from "../world/WorldTab";
import { mirrored } from "../words/language";
import { t } from "../words/words";
import { removeProgramNamed } from "./actions";
import { AddProgram } from "./AddProgram";
import { complain } from "./document";
import { useInView } from "./in-view";
import { later } from "./later";
import { useRenaming } from "./renaming";
import { Running } from "./Running";
import { StateShape } from "./StateShape";

const ProgramList = later(() => import("./ProgramList").then((chunk) => chunk.ProgramList), complain);

/** Lies over its tab: a list of tabs holds nothing but tabs. */
function NameField({ name }: { name: string }) {
  const [text, setText] = useState(name);
  const [left] = useState(() => document.getElementById(`tab-${name}`)?.offsetLeft ?? 0);
  const stop = () => useRenaming.setState({ program: null });
  const { mission, execute } = useStudio.getState();
  const wanted = text.trim();
  const command = wanted === name ? null : renameProgram(mission, name, wanted);
  const refused = command === null && wanted !== name;
  const keep = () => {
    if (command !== null) execute(command);
    stop();
  };
  // Back to where the name was asked for.
  useEffect(() => {
    const before = document.activeElement;
    return () => {
      requestAnimationFrame(() => {
        if (document.activeElement !== document.body) return;
        if (before instanceof HTMLElement && before.isConnected && before !== document.body) before.focus();
        else document.querySelector<HTMLElement>('.tabs [aria-selected="true"]')?.focus();
      });
    };
  }, []);
  return (
    <input
      className="tab-name-field"
      style={{ left }}
      data-testid="tab-name-field"
      aria-label={t("program.name")}
      aria-invalid={refused}
      value={text}
      size={Math.max(text.length, 6)}
      autoFocus
      onFocus={(event) => event.target.select()}
      onChange={(event) => setText(event.target.value)}
      onBlur={keep}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Enter") keep();
        else if (event.key === "Escape") stop();
      }}
    />
  );
}

/** What the watched agent does; when the run is over nobody does anything, but a failure stays to be seen. */
function stateShown(run: RunState, program: string): AgentActivity {
  const state = watchedAgent(run, program)?.state ?? "idle";
  return isLive(run.status) || state === "failed" || state === "stalled" ? state : "idle";
}

function Tab({ name, onKey }: { name: string; onKey: (event: KeyboardEvent) => void }) {
  const covered = useTeam((state) => state.open || state.world);
  const active = useStudio((studio) => studio.activeProgram === name) && !covered;
  const count = useStudio((studio) => studio.mission.agents.filter((agent) => agent.program === name).length);
  const errors = useStudio((studio) =>
    studio.report?.problems.some((one) => one.program === name && one.severity === "error"),
  );
  const state = useRun((run) => stateShown(run, name));
  return (
    <button
      type="button"
      role="tab"
      className="tab"
      id={`tab-${name}`}
      data-testid={`tab-${name}`}
      data-program={name}
      title={name}
      aria-selected={active}
      aria-controls="canvas-panel"
      tabIndex={active ? 0 : -1}
      onClick={() => {
        closeTeam();
        useStudio.getState().setActiveProgram(name);
      }}
      onDoubleClick={() => useRenaming.setState({ program: name })}
      onKeyDown={onKey}
    >
      <StateShape state={state} label={t(`tabs.state-${state}`)} />
      <span className="tab-name" dir="auto">
        {name}
      </span>
      {count === 1 ? null : (
        <span className="tab-count" aria-label={t("tabs.agents", { count })}>
          ×{count}
        </span>
      )}
      {errors === true ? <Icon name="circle-x" size={14} label={t("problems.error")} className="tab-error" /> : null}
    </button>
  );
}

/** The way to the programs whose tabs are not in view. */
function MorePrograms({ hidden }: { hidden: number }) {
  const [at, setAt] = useState<{ x: number; y: number } | null>(null);
  const button = useRef<HTMLButtonElement>(null);
  const leave = useCallback(() => setAt(null), []);
  return (
    <div className="more-programs" data-folded="">
      <button
        type="button"
        className="tool tool-named"
        ref={button}
        title={t("tabs.all")}
        aria-haspopup="listbox"
        aria-expanded={at !== null}
        data-testid="more-programs"
        onClick={(event) => {
          const box = event.currentTarget.getBoundingClientRect();
          setAt(at === null ? { x: mirrored() ? window.innerWidth - box.right : box.left, y: box.bottom + 4 } : null);
        }}
      >
        {t("tabs.more", { count: hidden })}
        <Icon name="chevron-down" size={14} />
      </button>
      {at === null ? null : (
        <ProgramList
          at={at}
          onLeave={leave}
          onClose={() => {
            leave();
            button.current?.focus();
          }}
        />
      )}
    </div>
  );
}

export function Tabs() {
  const programs = useStudio((studio) => studio.mission.programs);
  const activeProgram = useStudio((studio) => studio.activeProgram);
  const renaming = useRenaming((state) => state.program);
  const team = useTeam((state) => state.open);
  const world = useTeam((state) => state.world);
  const list = useRef<HTMLDivElement>(null);
  const row = useRef<HTMLDivElement>(null);
  const hidden = useInView(row);

  const onKey = (event: KeyboardEvent) => {
    // The team's tab and the world's are the last ones.
    const last = programs.length + 1;
    const at = world ? last : team ? last - 1 : programs.findIndex((program) => program.name === activeProgram);
    const on = mirrored() ? -1 : 1;
    const steps: Record<string, number> = {
      ArrowLeft: at - on,
      ArrowRight: at + on,
      Home: 0,
      End: last,
    };
    if (event.key === "Delete" && !team && !world) {
      event.preventDefault();
      event.stopPropagation();
      removeProgramNamed(activeProgram);
      // Its neighbour's tab has the focus then.
      requestAnimationFrame(() => list.current?.querySelector<HTMLElement>('[aria-selected="true"]')?.focus());
      return;
    }
    const wanted = steps[event.key];
    if (wanted === undefined) return;
    event.preventDefault();
    const place = (wanted + last + 1) % (last + 1);
    const next = programs[place];
    if (next === undefined) {
      if (place === last) showWorld();
      else openTeam();
      document.getElementById(place === last ? "tab-of-world" : "tab-of-team")?.focus();
      return;
    }
    closeTeam();
    useStudio.getState().setActiveProgram(next.name);
    list.current?.querySelector<HTMLElement>(`[data-program="${CSS.escape(next.name)}"]`)?.focus();
  };

  return (
    <div className="tabs">
      <div
        className="tabs-scroll"
        ref={row}
        onWheel={(event) => {
          if (event.deltaX === 0) event.currentTarget.scrollLeft += event.deltaY * (mirrored() ? -1 : 1);
        }}
      >
        <div
          className="tabs-list"
          role="tablist"
          aria-label={t("tabs.label")}
          aria-owns="tab-of-team tab-of-world"
          ref={list}
        >
          {programs.map(({ name }) => (
            <Tab key={name} name={name} onKey={onKey} />
          ))}
        </div>
        {programs.some(({ name }) => name === renaming) ? <NameField key={renaming} name={renaming ?? ""} /> : null}
      </div>
      <MorePrograms hidden={hidden} />
      <AddProgram />
      <div className="tabs-last">
        <TeamTab onKey={onKey} />
        <WorldTab onKey={onKey} />
      </div>
      <Running program={activeProgram} />
    </div>
  );
}
