/** What is chosen for a study: what varies, seeds, measures; how many runs it would have, and the command that does the same. */
import { useEffect, useMemo } from "react";

import { Refusal } from "../../components/Refusal";
import { grouped } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useRun } from "../../session/run";
import { useVaried } from "../../session/varied-axes";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { afterPause, endAll } from "../../ui/effects";
import { Field } from "../../ui/Field";
import { Axes } from "./Axes";
import { Command } from "./Command";
import { measureWords } from "./figures";
import { askedOf, changeSetup, LONGEST_S, secondsOf, toggleMeasure, useSetup } from "./setup";
import { begin, fetchPlan, useStudy } from "./study-work";

/** How long nothing is typed before the server is asked what comes of it. */
const QUIET_MS = 300;

export function Setup() {
  const mission = useStudio((studio) => studio.mission);
  const path = useStudio((studio) => studio.file.path);
  const failRate = useRun((run) => run.failRate);
  const axes = useVaried((varied) => varied.axes);
  const setup = useSetup();
  const choices = useStudy((state) => state.choices);
  const plan = useStudy((state) => state.plan);
  const wrong = useStudy((state) => state.wrong);
  const asked = useMemo(
    () => askedOf(setup, axes, choices),
    // eslint-disable-next-line react-hooks/exhaustive-deps -- these are read where it is made
    [setup, axes, choices, mission, path, failRate],
  );
  useEffect(() => {
    if (asked === null) return;
    const stop = new AbortController();
    return endAll(
      afterPause(QUIET_MS, () => void fetchPlan(asked, stop.signal)),
      () => stop.abort(),
    );
  }, [asked]);
  if (choices === null) return <p className="prose muted">{t("experiment.preparing")}</p>;
  if (choices.measures.length === 0) return <p className="prose muted">{t("experiment.errors")}</p>;
  return (
    <form
      className="experiment-form column slim gap-m"
      onSubmit={(event) => {
        event.preventDefault();
        if (asked !== null && plan !== null) begin(asked);
      }}
    >
      <Axes choices={choices} />
      <Measures offered={choices.measures} />
      <Limits />
      {asked === null ? null : <Refusal refused={wrong} />}
      <div className="row wrap">
        <Button icon="play" ink type="submit" testId="experiment-begin" disabled={asked === null || plan === null}>
          {plan === null
            ? t("experiment.begin-none")
            : t("experiment.begin", { count: plan.runs, runs: grouped(plan.runs) })}
        </Button>
      </div>
      {plan === null ? null : <Command text={plan.command} />}
    </form>
  );
}

function Measures({ offered }: { offered: readonly string[] }) {
  const chosen = useSetup((setup) => setup.measures);
  const own = useSetup((setup) => setup.own);
  const none = own.trim() === "" && !chosen.some((one) => offered.includes(one));
  return (
    <fieldset className="experiment-measures">
      <legend className="muted small-text">{t("experiment.measures")}</legend>
      <div className="row wrap">
        {offered.map((name) => (
          <Checkbox
            key={name}
            testId={`measure-${name}`}
            checked={chosen.includes(name)}
            set={() => toggleMeasure(name)}
          >
            {measureWords(name)}
          </Checkbox>
        ))}
      </div>
      <input
        className="field"
        dir="ltr"
        maxLength={400}
        data-testid="experiment-own-measure"
        aria-label={t("experiment.own-measure")}
        placeholder={t("experiment.own-measure")}
        value={own}
        onChange={(event) => changeSetup({ own: event.target.value })}
      />
      {none ? (
        <p className="warning" role="alert">
          {t("experiment.no-measure")}
        </p>
      ) : null}
    </fieldset>
  );
}

function Limits() {
  const seeds = useSetup((setup) => setup.seeds);
  const seconds = useSetup((setup) => setup.seconds);
  const wrong = secondsOf({ seconds }) === null;
  return (
    <>
      <div className="row wrap experiment-limits">
        <Field label={t("experiment.seeds")}>
          <input
            className="field"
            dir="ltr"
            maxLength={400}
            data-testid="experiment-seeds"
            value={seeds}
            onChange={(event) => changeSetup({ seeds: event.target.value })}
          />
        </Field>
        <Field label={t("experiment.seconds")}>
          <input
            className="field"
            inputMode="decimal"
            maxLength={8}
            data-testid="experiment-seconds"
            aria-invalid={wrong}
            aria-describedby={wrong ? "experiment-seconds-wrong" : undefined}
            value={seconds}
            onChange={(event) => changeSetup({ seconds: event.target.value })}
          />
        </Field>
      </div>
      {wrong ? (
        <p className="warning" id="experiment-seconds-wrong" role="alert">
          {t("sweep.seconds-wrong", { most: grouped(LONGEST_S) })}
        </p>
      ) : null}
    </>
  );
}
