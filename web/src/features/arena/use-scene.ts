/** What the arena shows, as hooks: the scene, who of it is watched, and both in words. */
import { useEffect, useMemo, useRef, useState } from "react";

import {
  actorsOf,
  hasOtherPlaces,
  lookAt,
  type Scene,
  sceneBefore,
  sceneOf,
  sceneOfReal,
} from "../../components/scene/scene";
import { useStudio } from "../../model/studio";
import { posesAt, watchFrames } from "../../session/poses";
import { isHardwareRun, isLive, useRun } from "../../session/run";
import { summary } from "./summary";

const SPOKEN_MS = 250;

export function useScene(): Scene | null {
  const run = useRun();
  const mission = useStudio((studio) => studio.mission);
  const catalogue = useStudio((studio) => studio.catalogue);
  const ownWorld = useStudio((studio) => studio.world);
  const before = useMemo(
    () => (ownWorld === null ? null : sceneBefore(mission, ownWorld, catalogue)),
    [mission, ownWorld, catalogue],
  );
  const { world, agents, mission: ran } = run;
  // A run that is over gives way to what was edited since; going back in it brings it back.
  const over = ran !== null && !run.real && !isLive(run.status);
  const edited = useMemo(() => over && hasOtherPlaces(mission, ran), [over, mission, ran]);
  const actors = useMemo(
    () => (world === null ? [] : actorsOf(agents, mission, catalogue, world)),
    [world, agents, mission, catalogue],
  );
  // Robots that stand still give way to the mission again; a recording stays.
  const shown = run.real ? isLive(run.status) : !edited;
  const real = shown && isHardwareRun(agents);
  const place = real ? (world ?? ownWorld) : null;
  const unplaced = useMemo(() => (place === null ? null : sceneOfReal(place)), [place]);
  const seen = useMemo(
    () => (world !== null && actors.length > 0 && !edited ? sceneOf(run, actors, world) : before),
    [run, world, actors, before, edited],
  );
  return unplaced ?? seen;
}

/** Who wears the ring: the agent watched in the program that is open. */
export function useSelected(scene: Scene | null): string {
  const program = useStudio((studio) => studio.activeProgram);
  const chosen = useRun((run) => run.selectedAgent[program]);
  const own = scene?.actors.filter((actor) => actor.program === program) ?? [];
  return (own.find((actor) => actor.name === chosen) ?? own[0])?.name ?? "";
}

/** The scene in words, renewed a few times a second at most. */
export function useSummary(scene: Scene | null): string {
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
