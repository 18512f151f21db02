/** The run: its tools, what it is doing, its timeline, and the bars of recordings and of runs in other windows. */
import "./strip.css";

import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { changeSpeed, pause, run as begin, stepVertex } from "../../session/actions";
import { complain } from "../../session/document";
import { type Feature, STOP_KEY, stopEverything } from "../../session/features";
import { keyFor } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { saveRun, useOpenRecording } from "../../session/recordings";
import { can, isLive, type RunState, useRun } from "../../session/run";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";
import { EventStrip } from "./EventStrip";
import { KEYS } from "./keys";
import { Running } from "./Running";
import { RunStatus } from "./RunStatus";
import { RunTools } from "./RunTools";
import { Watching } from "./Watching";

/** What is shown of real robots is that old at most while it follows them. */
const NOW_MS = 1000;
const RecordingBar = later(() => import("./RecordingBar").then((chunk) => chunk.RecordingBar), complain);
const BehindBar = later(() => import("./BehindBar").then((chunk) => chunk.BehindBar), complain);

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

function RunningInView() {
  const program = useStudio((studio) => studio.activeProgram);
  return <Running program={program} />;
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
      menuItem("run-save", t("recording.save"), null, () => saveRun().catch(complain), name === ""),
      { kind: "heading", id: "run-speed", label: t("run.speed") },
      menuItem("run-slower", t("run.slower"), key(KEYS.slower), () => changeSpeed(-1)),
      menuItem("run-faster", t("run.faster"), key(KEYS.faster), () => changeSpeed(1)),
      { kind: "radio", id: "run-real-time", label: t("run.real-time"), checked: speed === 1, run: () => setSpeed(1) },
      { kind: "radio", id: "run-as-fast", label: t("run.as-fast"), checked: speed === 0, run: () => setSpeed(0) },
    ],
  };
}

export const run: Feature = {
  name: "run",
  slots: { banner: Bars, tools: RunTools, status: RunStatus, "tabs-end": RunningInView, bottom: EventStrip },
  keys: KEYS,
  words: { "run-save": "search.trace" },
  elsewhere: [{ name: "elsewhere.timeline-name", says: "elsewhere.timeline", also: "search.timeline" }],
  useMenu,
  useOn: () => useRun(({ status }) => isLive(status)),
  stop: () => useRun.getState().stop(),
};
