/** The run: its tools, what it is doing, its timeline, and the bars of recordings and of runs in other windows. */
import "./strip.css";

import { useShallow } from "zustand/react/shallow";

import { t } from "../../i18n/words";
import { programInView, useStudio } from "../../model/studio";
import { changeSpeed, pause, reveal, run as begin, stepVertex } from "../../session/actions";
import { useDisk } from "../../session/disk";
import { reportError } from "../../session/document";
import { type Feature, STOP_KEY, stopEverything } from "../../session/features";
import { keyFor } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { saveRun, useOpenRecording } from "../../session/recordings";
import { can, isLive, isOurs, type RunState, useActiveVertices, useRun, watchedAgent } from "../../session/run";
import { useShown } from "../../session/simple-view";
import { later } from "../../ui/later";
import { menuItem, menuRadio } from "../../ui/menu-model";
import { EventStrip } from "./EventStrip";
import { KEYS } from "./keys";
import type { Thread } from "./RunningRow";
import { RunStatus } from "./RunStatus";
import { RunTools } from "./RunTools";

/** What is shown of real robots is that old at most while it follows them. */
const NOW_MS = 1000;
const RecordingBar = later(() => import("./RecordingBar").then((chunk) => chunk.RecordingBar), reportError);
const BehindBar = later(() => import("./BehindBar").then((chunk) => chunk.BehindBar), reportError);

/** Whether real robots, or a team of processes, are further than what is shown of them. */
function isBehind({ real, isFleet, status, tick, latest, tickMs }: RunState): boolean {
  return (real || isFleet) && (status === "paused" || (status === "running" && (latest - tick) * tickMs > NOW_MS));
}

function Bars() {
  const recording = useOpenRecording();
  const behind = useRun(isBehind);
  return (
    <>
      {recording === null ? null : <RecordingBar open={recording} />}
      {behind ? <BehindBar /> : null}
      <Watching />
    </>
  );
}

function useMenu(): MenuEntries {
  const status = useRun((state) => state.status);
  const speed = useRun((state) => state.speed);
  const { step, setSpeed, tick, name, watching } = useRun.getState();
  const goesBack = tick > 0 && can("seek", useRun.getState());
  const paused = status === "paused" && !watching;
  const live = isLive(status);
  const key = keyFor.page;
  return {
    run: [
      menuItem("run-run", paused ? t("run.resume") : t("run.run"), key(KEYS.run), begin, live && !paused),
      menuItem("run-pause", t("run.pause"), key(KEYS.pause), pause, status !== "running" || watching),
      menuItem("run-step", t("run.step"), key(KEYS.step), () => step(), !paused),
      menuItem("run-step-vertex", t("run.step-vertex"), key(KEYS.stepVertex), () => stepVertex(false), !paused),
      menuItem("run-step-back", t("run.step-back"), key(KEYS.stepBack), () => step("tick", true), !goesBack),
      menuItem(
        "run-step-vertex-back",
        t("run.step-vertex-back"),
        key(KEYS.stepVertexBack),
        () => stepVertex(true),
        !goesBack,
      ),
      menuItem("run-stop", t(watching ? "watching.leave" : "run.stop"), key(STOP_KEY), stopEverything, !live),
      menuItem("run-save", t("recording.save"), null, () => saveRun().catch(reportError), name === ""),
      { kind: "heading", id: "run-speed", label: t("run.speed") },
      menuItem("run-slower", t("run.slower"), key(KEYS.slower), () => changeSpeed(-1)),
      menuItem("run-faster", t("run.faster"), key(KEYS.faster), () => changeSpeed(1)),
      menuRadio("run-real-time", t("run.real-time"), speed === 1, () => setSpeed(1)),
      menuRadio("run-as-fast", t("run.as-fast"), speed === 0, () => setSpeed(0)),
    ],
  };
}

const Bar = later(() => import("./WatchingBar").then((chunk) => chunk.WatchingBar), reportError);

/** The run that is watched, or can be; "" for none. Who has a run of their own going on is not offered another. */
function useWatchable(): string {
  const watched = useRun((run) => (run.watching ? run.name : ""));
  const busy = useRun((run) => isLive(run.status));
  const offered = useDisk(({ runs }) => runs.find((name) => !isOurs(name)) ?? "");
  return watched !== "" || busy ? watched : offered;
}

/** Whether there is a run of another window to watch; the bar that says so is fetched when there is one. */
export function Watching() {
  const run = useWatchable();
  return run === "" ? null : <Bar run={run} />;
}

const Row = later(() => import("./RunningRow").then((chunk) => chunk.RunningRow), reportError);

function useThreads(program: string): Thread[] {
  const active = useActiveVertices(program);
  const vertices = useStudio((studio) => programInView(studio)?.vertices);
  return [...active]
    .flatMap(([vertex, slots]) => slots.map((slot) => ({ slot, vertex })))
    .sort((a, b) => a.slot - b.slot)
    .map(({ slot, vertex }) => ({
      slot,
      label: t("tabs.thread", { slot, vertex: vertices?.find((one) => one.id === vertex)?.element ?? vertex }),
      go: () => reveal(program, [vertex]),
    }));
}

/**
 * What runs in the program in view: which agent is watched, where there are several, and a token per live thread that leads to
 * its vertex. Tokens without room are a list behind their number.
 */
function Running() {
  const program = useStudio((studio) => studio.activeProgram);
  const all = useThreads(program);
  const threads = useShown("threads") ? all : [];
  const chosen = useRun((run) => watchedAgent(run, program)?.name ?? "");
  // The names stay while what the agents do changes: there may be thousands.
  const names = useRun(
    useShallow((run) => run.agents.filter((agent) => agent.program === program).map((agent) => agent.name)),
  );
  if (threads.length === 0 && names.length < 2) return null;
  return <Row threads={threads} names={names} chosen={chosen} />;
}

export const run: Feature = {
  name: "run",
  slots: { banner: Bars, tools: RunTools, status: RunStatus, "tabs-end": Running, bottom: EventStrip },
  keys: KEYS,
  words: { "run-save": "search.trace" },
  elsewhere: [{ name: "elsewhere.timeline-name", says: "elsewhere.timeline", also: "search.timeline" }],
  useMenu,
  useOn: () => useRun(({ status }) => isLive(status)),
  stop: () => useRun.getState().stop(),
};
