/** Puts what the switches show onto the arena, and lets it sound. Draws nothing of the page itself but the menu. */
import { useEffect, useMemo } from "react";

import type { Painter } from "../../../components/scene/painter";
import type { Scene } from "../../../components/scene/scene";
import { lastFrame, watchFrames, wayToLast } from "../../../session/poses";
import { useRun } from "../../../session/run";
import { useStage } from "../../../session/stage";
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
  const layers = useMemo(() => new StageLayers(() => painter.paintSoon()), [painter]);
  useEffect(() => {
    layers.begin(run);
    const record = () => {
      const frame = lastFrame();
      if (frame === null) layers.begin(run);
      else layers.record(frame, wayToLast());
    };
    record();
    return watchFrames(record);
  }, [layers, run]);
  useEffect(() => {
    layers.show(on, selected, !large);
    painter.setLayers({ place: !large, names: large && on.names }, layers);
  }, [painter, layers, on, large, selected]);
  useEffect(() => layers.celebrateRuns(), [layers]);
  useSound(on.sound);
  useStatesSaid(scene);
  const actor = scene?.actors.find(({ name }) => name === selected);
  useGamepad(actor);
  return <ShownMenu />;
}
