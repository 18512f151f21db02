/** A run of the model in its world, zone by zone. */
import { grouped } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import type { Mission } from "../../model/types";
import { Icon } from "../../theme";
import { SceneArena } from "./SceneArena";
import { StepBar, STEPS_A_SECOND, useSteps } from "./StepBar";
import { SceneEvents } from "./SceneEvents";
import { type ModelRun, repeatedFrom } from "./table";
import { useWorldOf } from "./world";

interface Props {
  run: ModelRun;
  mission: Mission;
  /** The step that decided the run; -1 for none. */
  decided?: number;
}

export function StepArena({ run, mission, decided = -1 }: Props) {
  const world = useWorldOf(mission);
  const { scenes } = run;
  const steps = useSteps({ length: scenes.length - 1, unit: 1, rate: STEPS_A_SECOND, again: repeatedFrom(run) });
  const scene = scenes[Math.floor(steps.at)];
  if (world === null || scene === undefined || scenes.length < 2) return null;
  const moment = decided < 0 ? -1 : scenes.findIndex(({ step }) => step === decided);
  const repeats = run.repeats_from >= 0 && scene.step >= run.repeats_from;
  return (
    <div className="check-steps" data-testid="check-steps" data-step={scene.step}>
      <SceneArena scene={scene} mission={mission} world={world} />
      <StepBar steps={steps} label={t("check.zone-by-zone")} decided={moment}>
        {scene.step === 0
          ? t("check.step-first")
          : t("check.step-of", { step: grouped(scene.step), steps: grouped(run.steps) })}
        {repeats ? <Icon name="infinity" size={14} label={t("check.repeats")} /> : null}
      </StepBar>
      <SceneEvents run={run} scene={scene} />
    </div>
  );
}
