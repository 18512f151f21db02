/**
 * Watches what the person does while a tutorial is on: each change of the mission is held against it by the server, and
 * so is the mission that was run or saved when that happens.
 */
import type { Tutorial } from "../../api/generated";
import { tutorialApi } from "../../api/tutorials";
import { useStudio } from "../../model/studio";
import type { Mission } from "../../model/types";
import { makeChecker } from "../../session/checking";
import { isLive, type RunStatus, useRun } from "../../session/run";
import { heardEvent, heardFits, useTutorial } from "./state";

/** What a change of the run's status means in the words of tutorials. */
export function eventsOf(status: RunStatus, before: RunStatus): string[] {
  if (status === before) return [];
  if (before === "connecting" && status === "running") return ["run-started"];
  if (!isLive(before) || isLive(status) || status === "idle") return [];
  return status === "done" ? ["run-done", "run-ended"] : ["run-ended"];
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
      if (answer !== null && useTutorial.getState().tutorial === under) heardFits(answer.fits);
    },
    fail: () => undefined,
  });
  const again = () => {
    const { mission, file } = useStudio.getState();
    if (useTutorial.getState().tutorial !== null) request(mission, file.path);
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
    const events = state.watching ? [] : eventsOf(state.status, before.status);
    if (events.length > 0) void happened(events, running);
  });
  again();
  return () => {
    offTutorial();
    offStudio();
    offRun();
  };
}
