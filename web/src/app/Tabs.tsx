/**
 * The programs of the mission as tabs, then what runs in the one that is open.
 *
 * Each tab shows how many agents run its program and, during a run, the state of the one that is watched. Programs without
 * room are in a list behind their row; the tabs of the features (team, world) stand behind it and keep their place.
 */
import { type KeyboardEvent, useCallback, useEffect, useRef, useState } from "react";

import type { AgentActivity } from "../api/wire";
import { Slot } from "../components/Slot";
import { StateShape } from "../components/StateShape";
import { mirrored } from "../i18n/language";
import { t } from "../i18n/words";
import { renameProgram } from "../model/commands/changePrograms";
import { execute, useStudio } from "../model/studio";
import { TEAM_ROBOT } from "../model/team-robot";
import { typedName } from "../model/typed-name";
import { removeProgramNamed } from "../session/actions";
import { useHasCounterexample } from "../session/counterexample";
import { reportError } from "../session/document";
import type { FeatureTab } from "../session/features";
import { isLive, type RunState, useRun, watchedAgent } from "../session/run";
import { useShownNames } from "../session/simple-view";
import { closeTeam, useTeam } from "../session/team-view";
import { Icon } from "../theme";
import { useInView } from "../ui/in-view";
import { later } from "../ui/later";
import { tabAfter } from "../ui/TabList";
import { AddProgram } from "./AddProgram";
import { FEATURES } from "./features";
import { renameInTab, useRenaming } from "./tab-rename";

const TABS = FEATURES.flatMap(({ tab }) => tab ?? []);

const ProgramList = later(() => import("./ProgramList").then((chunk) => chunk.ProgramList), reportError);

/** Lies over its tab: a list of tabs holds nothing but tabs. */
function NameField({ name }: { name: string }) {
  const [text, setText] = useState(name);
  const [left] = useState(() => document.getElementById(`tab-${name}`)?.offsetLeft ?? 0);
  const stop = () => renameInTab(null);
  const { mission, catalogue } = useStudio.getState();
  const wanted = typedName(text);
  const command = wanted === name ? null : renameProgram(mission, name, wanted, catalogue);
  const refused = command === null && wanted !== name;
  const keep = () => {
    execute(command);
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
      className="tab-name-field field"
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

/** The state of the watched agent; after the run it is idle, but a failure is still shown. */
function stateShown(run: RunState, program: string): AgentActivity {
  const state = watchedAgent(run, program)?.state ?? "idle";
  return isLive(run.status) || state === "failed" || state === "stalled" ? state : "idle";
}

/** How many agents there are; nothing where there is nothing to count. */
function Count({ count, sign = "" }: { count: number | undefined; sign?: string }) {
  if (count === undefined) return null;
  return (
    <span className="tab-count muted tiny-text" aria-label={t("tabs.agents", { count })}>
      {sign}
      {count}
    </span>
  );
}

function Errors({ there }: { there: boolean }) {
  return there ? <Icon name="circle-x" size={14} label={t("problems.error")} className="tab-error" /> : null;
}

interface TabProps {
  onKey: (event: KeyboardEvent) => void;
}

function Tab({ name, onKey }: TabProps & { name: string }) {
  const covered = useTeam((state) => state.open || state.world);
  const active = useStudio((studio) => studio.activeProgram === name) && !covered;
  const count = useStudio((studio) => studio.mission.agents.filter((agent) => agent.program === name).length);
  // Where there is a program of the team, others run as a part of it, and are no agent's own.
  const inTeam = useStudio((studio) => studio.mission.programs.some((program) => program.robot === TEAM_ROBOT));
  const errors = useStudio((studio) =>
    studio.report?.problems.some((one) => one.program === name && one.severity === "error"),
  );
  const state = useRun((run) => stateShown(run, name));
  const guilty = useHasCounterexample(name);
  return (
    <button
      type="button"
      role="tab"
      className="tab inline-row nowrap focus-inside relative"
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
      onDoubleClick={() => renameInTab(name)}
      onKeyDown={onKey}
    >
      <StateShape state={state} label={t(`tabs.state-${state}`)} />
      <span className="tab-name" dir="auto">
        {name}
      </span>
      <Count count={count === 1 || (count === 0 && inTeam) ? undefined : count} sign="×" />
      <Errors there={errors === true} />
      {guilty ? (
        <span className="tab-cross badge rigid">
          <Icon name="x" size={14} label={t("guilty.broken")} />
        </span>
      ) : null}
    </button>
  );
}

/** The tab of a feature. */
function LastTab({ tab: { name, icon, label, open, useTab }, onKey }: TabProps & { tab: FeatureTab }) {
  const { open: shown, errors, count } = useTab();
  const isDetail = !useShownNames().tab(name);
  // Whatever led to what it shows, the way back stands here; and a mistake is told where it is.
  if (isDetail && !shown && !errors) return null;
  return (
    <button
      type="button"
      role="tab"
      className={`tab inline-row nowrap relative tab-${name}`}
      id={`tab-of-${name}`}
      title={t(label)}
      data-testid={`tab-of-${name}`}
      aria-selected={shown}
      {...(shown ? { "aria-controls": `${name}-panel` } : {})}
      tabIndex={shown ? 0 : -1}
      onClick={open}
      onKeyDown={onKey}
    >
      <Icon name={icon} size={16} />
      <span className="tab-name">{t(label)}</span>
      <Count count={count} />
      <Errors there={errors} />
    </button>
  );
}

/** The way to the programs whose tabs are not in view. */
function MorePrograms({ hidden }: { hidden: number }) {
  const [at, setAt] = useState<{ x: number; y: number } | null>(null);
  const button = useRef<HTMLButtonElement>(null);
  const leave = useCallback(() => setAt(null), []);
  return (
    <div className="more-programs rigid aligned" data-folded="">
      <button
        type="button"
        className="tool tool-named rigid nowrap medium gap-m relative"
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
  const list = useRef<HTMLDivElement>(null);
  const row = useRef<HTMLDivElement>(null);
  const hidden = useInView(row);

  const onKey = (event: KeyboardEvent) => {
    // The features' tabs are the last ones.
    const count = programs.length + TABS.length;
    const open = TABS.findIndex(({ isOpen }) => isOpen());
    const at = open < 0 ? programs.findIndex((program) => program.name === activeProgram) : programs.length + open;
    if (event.key === "Delete" && open < 0) {
      event.preventDefault();
      event.stopPropagation();
      removeProgramNamed(activeProgram);
      // Its neighbour's tab has the focus then.
      requestAnimationFrame(() => list.current?.querySelector<HTMLElement>('[aria-selected="true"]')?.focus());
      return;
    }
    const place = tabAfter(event, at, count);
    if (place === null) return;
    event.preventDefault();
    const next = programs[place];
    if (next === undefined) {
      const tab = TABS[place - programs.length];
      tab?.open();
      document.getElementById(`tab-of-${tab?.name ?? ""}`)?.focus();
      return;
    }
    closeTeam();
    useStudio.getState().setActiveProgram(next.name);
    list.current?.querySelector<HTMLElement>(`[data-program="${CSS.escape(next.name)}"]`)?.focus();
  };

  return (
    <div className="tabs rigid flex">
      <div
        className="tabs-scroll aligned relative"
        ref={row}
        onWheel={(event) => {
          if (event.deltaX === 0) event.currentTarget.scrollLeft += event.deltaY * (mirrored() ? -1 : 1);
        }}
      >
        <div
          className="tabs-list flex gap-m"
          role="tablist"
          aria-label={t("tabs.label")}
          aria-owns={TABS.map(({ name }) => `tab-of-${name}`).join(" ")}
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
      <div className="tabs-last row rigid">
        {TABS.map((tab) => (
          <LastTab key={tab.name} tab={tab} onKey={onKey} />
        ))}
      </div>
      <Slot name="tabs-end" />
    </div>
  );
}
