/** A broken run and one that keeps the property, side by side from the moment that decided it, in step. */
import type { OtherWay, Scene } from "../../api/generated";
import { grouped } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import type { Mission } from "../../model/types";
import { Icon } from "../../theme";
import { SceneArena } from "./SceneArena";
import { SceneEvents } from "./SceneEvents";
import { StepBar, useSteps } from "./StepBar";
import { type ModelRun, momentsFrom, otherRun, sceneAt } from "./table";
import { useWorldOf } from "./world";

interface Props {
  broken: ModelRun;
  other: OtherWay;
  /** The step that decided. */
  decided: number;
  mission: Mission;
}

export function BothWays({ broken, other, decided, mission }: Props) {
  const world = useWorldOf(mission);
  const kept = otherRun(other);
  const moments = momentsFrom([broken, kept], decided);
  const last = moments.length - 1;
  const steps = useSteps(last, (at) => (at < last ? at + 1 : null));
  const step = moments[steps.at];
  if (world === null || step === undefined || last < 1) return null;
  const ways: [string, string, ModelRun, Scene | null][] = [
    ["broken", t("check.way-broken"), broken, sceneAt(broken, step)],
    ["kept", other.ends_well ? t("check.way-well") : t("check.way-kept"), kept, sceneAt(kept, step)],
  ];
  return (
    <div className="check-steps" data-testid="check-both" data-step={step}>
      <div className="check-both">
        {ways.map(([name, words, run, scene]) =>
          scene === null ? null : (
            <figure key={name} className="column gap-xs" data-testid={`check-way-${name}`} data-step={scene.step}>
              <figcaption className="small-text row gap-xs">
                <Icon name={name === "kept" ? "circle-check" : "circle-x"} size={14} />
                {words}
                {run.repeats_from >= 0 && step > run.repeats_from ? (
                  <Icon name="infinity" size={14} label={t("check.repeats")} />
                ) : null}
              </figcaption>
              <SceneArena scene={scene} mission={mission} world={world} />
              <SceneEvents run={run} scene={scene} />
            </figure>
          ),
        )}
      </div>
      <StepBar steps={steps} label={t("check.both-in-step")}>
        {t("check.step-of", { step: grouped(step), steps: grouped(moments[last] ?? step) })}
      </StepBar>
    </div>
  );
}
