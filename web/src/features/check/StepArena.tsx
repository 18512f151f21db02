/** A run of the model in its world, zone by zone. */
import { type KeyboardEvent, useEffect, useState } from "react";

import { mirrored } from "../../i18n/language";
import { grouped } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import type { Mission } from "../../model/types";
import { Icon } from "../../theme";
import { Tool } from "../../ui/Tool";
import { SceneArena } from "./SceneArena";
import { type ModelRun, sceneAfter } from "./table";
import { useWorldOf } from "./world";

/** How long a step is shown while it plays. */
const STEP_MS = 700;

interface Props {
  run: ModelRun;
  mission: Mission;
  /** The step that decided the run; -1 for none. */
  decided?: number;
}

export function StepArena({ run, mission, decided = -1 }: Props) {
  const world = useWorldOf(mission);
  const [at, setAt] = useState(0);
  const [plays, setPlays] = useState(false);
  const { scenes } = run;
  const last = scenes.length - 1;
  const after = sceneAfter(run, at);
  useEffect(() => {
    if (!plays) return;
    const timer = setTimeout(() => (after === null ? setPlays(false) : setAt(after)), STEP_MS);
    return () => clearTimeout(timer);
  }, [plays, after]);
  const scene = scenes[at];
  if (world === null || scene === undefined || scenes.length < 2) return null;

  const moment = decided < 0 ? -1 : scenes.findIndex(({ step }) => step === decided);
  const go = (to: number) => {
    setPlays(false);
    setAt(Math.min(Math.max(to, 0), last));
  };
  const pressed = (event: KeyboardEvent) => {
    const forward = mirrored() ? "ArrowLeft" : "ArrowRight";
    if (event.key === forward) go(at + 1);
    else if (event.key === (mirrored() ? "ArrowRight" : "ArrowLeft")) go(at - 1);
    else if (event.key === "Home") go(0);
    else if (event.key === "End") go(last);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const said = run.events.filter(({ step }) => step === scene.step - 1);
  const repeats = run.repeats_from >= 0 && scene.step >= run.repeats_from;
  return (
    <div className="check-steps" data-testid="check-steps" data-step={scene.step}>
      <SceneArena scene={scene} mission={mission} world={world} />
      <div
        className="check-steps-row row small-text gap-xs"
        role="group"
        aria-label={t("check.zone-by-zone")}
        onKeyDown={pressed}
      >
        <Tool small icon="step-back" label={t("check.step-back")} disabled={at === 0} onClick={() => go(at - 1)} />
        <Tool
          small
          icon={plays ? "pause" : "play"}
          label={plays ? t("run.pause") : t("check.step-play")}
          testId="check-steps-play"
          onClick={() => {
            if (!plays && at === last) setAt(0);
            setPlays(!plays);
          }}
        />
        <Tool
          small
          icon="step-forward"
          label={t("check.step-on")}
          testId="check-step-on"
          disabled={at === last}
          onClick={() => go(at + 1)}
        />
        {moment < 0 ? null : (
          <Tool
            small
            icon="git-fork"
            label={t("check.to-moment")}
            testId="check-to-moment"
            onClick={() => go(moment)}
          />
        )}
        <span className="check-count figures" role="status">
          {scene.step === 0
            ? t("check.step-first")
            : t("check.step-of", { step: grouped(scene.step), steps: grouped(run.steps) })}
          {repeats ? <Icon name="infinity" size={14} label={t("check.repeats")} /> : null}
        </span>
      </div>
      <p className="muted small-text">
        {said.map(({ text }, index) => (
          <span key={index}>
            <Said text={text} />{" "}
          </span>
        ))}
      </p>
    </div>
  );
}
