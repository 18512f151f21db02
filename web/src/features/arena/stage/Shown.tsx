/** Puts what the switches show onto the arena, and lets it sound. Draws nothing of the page itself but the menu. */
import { useEffect, useMemo } from "react";

import type { Painter } from "../../../components/scene/painter";
import type { Scene } from "../../../components/scene/scene";
import { useOpenExercise } from "../../../session/open-exercise";
import { recordFrames, watchFrames } from "../../../session/poses";
import { isEnded, useRun } from "../../../session/run";
import { useShown } from "../../../session/simple-view";
import { useStage } from "../../../session/stage";
import { endAll } from "../../../ui/effects";
import { setFacts } from "./EndCard";
import { useGamepad } from "./gamepad";
import { StageLayers } from "./layers";
import { ShownMenu } from "./shown-menu";
import { useSound } from "./sound";
import { useStatesSaid } from "./states-said";
import { useOn } from "./switches";

interface ShownProps {
  scene: Scene | null;
  selected: string;
  painter: Painter;
}

export function Shown({ scene, selected, painter }: ShownProps) {
  const on = useOn();
  const large = useStage((stage) => stage.large);
  const run = useRun((state) => state.name);
  const places = useShown("places");
  const layers = useMemo(() => new StageLayers(() => painter.paintSoon()), [painter]);
  useEffect(() => {
    layers.begin(run);
    return recordFrames((frame, joined) => layers.record(frame, joined));
  }, [layers, run]);
  useEffect(() => {
    layers.show(on, selected, !large);
    painter.setLayers({ place: places && !large, names: large && on.names }, layers);
  }, [painter, layers, on, large, places, selected]);
  useEffect(() => layers.celebrateGoals(), [layers]);
  useEffect(() => {
    const account = () => {
      const now = useRun.getState();
      if (isEnded(now.status)) setFacts(layers.facts(now), now.name);
    };
    account();
    return endAll(useRun.subscribe(account), watchFrames(account), useOpenExercise.subscribe(account));
  }, [layers]);
  useSound(on.sound);
  useStatesSaid(scene);
  const actor = scene?.actors.find(({ name }) => name === selected);
  useGamepad(actor);
  return <ShownMenu />;
}
