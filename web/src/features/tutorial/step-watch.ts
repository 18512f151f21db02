/**
 * Watches what the person does while a tutorial is on: each change of the mission is held against it by the server, and
 * so is the mission that was run or saved when that happens.
 */
import type { Tutorial } from "../../api/generated";
import { tutorialApi } from "../../api/tutorials";
import { useStudio } from "../../model/studio";
import { TEAM_ROBOT } from "../../model/team-robot";
import type { Mission } from "../../model/types";
import { makeChecker } from "../../session/checking";
import { useCodeSide } from "../../session/code-side";
import { useDock } from "../../session/dock";
import { MEMBERS } from "../../session/members";
import { isLive, type RunState, type RunStatus, useRun } from "../../session/run";
import { endAll } from "../../ui/effects";
import { heardEvent, heardFits, useTutorial } from "./state";

/** A team as the run knows it. */
type TeamNow = RunState["team"];
type TeamRun = Pick<RunState, "team" | "events">;

function memberWaits(team: TeamNow): boolean {
  return team?.meetings.some((one) => one.here_count > 0 && one.here_count < one.count) ?? false;
}

function replaced(team: TeamNow): string[] {
  return (
    team?.members.flatMap((one) => (one.stands_for === "" || one.stands_for === one.name ? [] : [one.stands_for])) ?? []
  );
}

function missed(team: TeamNow): string[] {
  return team?.members.flatMap((one) => (one.missed ? [one.name] : [])) ?? [];
}

/** What a change of the run means in the words of tutorials, where it is a team's. */
export function eventsOfTeam(run: TeamRun, before: TeamRun): string[] {
  const [now, then] = [run.team, before.team];
  if (now === null) return [];
  const found: string[] = [];
  if (now !== then) {
    const taken = replaced(now).filter((name) => missed(now).includes(name));
    if (memberWaits(now) && !memberWaits(then)) found.push("member-waits");
    if (taken.some((name) => !replaced(then).includes(name))) found.push("robot-replaced");
    if (missed(now).some((name) => !missed(then).includes(name) && !taken.includes(name))) found.push("robot-dropped");
  }
  const { events } = run;
  if (events !== before.events) {
    const known = new Set(before.events);
    if (events.some((one) => one.kind === "failure" && !known.has(one))) found.push("robot-failed");
  }
  return found;
}

/** What is shown as the page is now, in the words of tutorials: as long as it is, steps that want it are done. */
function shownNow(): string[] {
  const found: string[] = [];
  if (useDock.getState().open === MEMBERS && missed(useRun.getState().team).length > 0) found.push("members-shown");
  const isTeam = useStudio.getState().mission.programs.some((one) => one.robot === TEAM_ROBOT);
  if (isTeam && useCodeSide.getState().side === "projection") found.push("projection-shown");
  return found;
}

/** What a change of the run's status means in the words of tutorials. */
export function eventsOf(status: RunStatus, before: RunStatus): string[] {
  if (status === before) return [];
  if (before === "connecting" && status === "running") return ["run-started"];
  if (!isLive(before) || isLive(status) || status === "idle") return [];
  if (status === "done") return ["run-done", "run-ended"];
  return status === "failed" ? ["run-failed", "run-ended"] : ["run-ended"];
}

async function happened(events: readonly string[], mission: Mission): Promise<void> {
  const { tutorial } = useTutorial.getState();
  const wanted = events.filter((event) => tutorial?.steps.some((step) => step.events.includes(event)));
  if (tutorial === null || wanted.length === 0) return;
  try {
    const { fits } = await tutorialApi.watch(tutorial.name, mission, useStudio.getState().file.path);
    if (useTutorial.getState().tutorial !== tutorial) return;
    for (const event of wanted) heardEvent(event, fits);
  } catch {
    // Without a server the checker says so; the step is done another time.
  }
}

/** Starts watching; the returned function ends it. */
export function keepWatching(): () => void {
  let running: Mission = useStudio.getState().mission;
  let under: Tutorial | null = null;
  const request = makeChecker<{ fits: readonly boolean[] } | null>({
    check: async (mission, path, signal) => {
      const { tutorial } = useTutorial.getState();
      under = tutorial;
      return tutorial === null ? null : tutorialApi.watch(tutorial.name, mission, path, signal);
    },
    accept: (answer) => {
      if (answer !== null && useTutorial.getState().tutorial === under) {
        heardFits(answer.fits);
        for (const event of ["edited", ...shownNow()]) heardEvent(event, answer.fits);
      }
    },
    fail: () => undefined,
  });
  const again = () => {
    const { mission, file } = useStudio.getState();
    if (useTutorial.getState().tutorial !== null) request(mission, file.path);
  };
  let shown: string[] = [];
  const look = () => {
    const now = shownNow();
    const more = now.filter((event) => !shown.includes(event));
    shown = now;
    if (more.length > 0) void happened(more, useStudio.getState().mission);
  };
  const offTutorial = useTutorial.subscribe((state, before) => {
    if (state.tutorial !== before.tutorial) again();
  });
  const offStudio = useStudio.subscribe((state, before) => {
    if (state.mission !== before.mission) again();
    if (state.change !== before.change && state.change.kind === "save") void happened(["saved"], state.mission);
  });
  const offRun = useRun.subscribe((state, before) => {
    if (state.status === "connecting" && before.status !== "connecting") running = useStudio.getState().mission;
    const events = state.watching ? [] : [...eventsOf(state.status, before.status), ...eventsOfTeam(state, before)];
    if (events.length > 0) void happened(events, running);
    if (state.team !== before.team) look();
  });
  const offDock = useDock.subscribe(look);
  const offCode = useCodeSide.subscribe(look);
  again();
  return endAll(offTutorial, offStudio, offRun, offDock, offCode);
}
