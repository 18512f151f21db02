/** What the mission's own properties are in the run that has ended; a broken one leads to its moment. */
import { type ReactNode, useEffect, useState } from "react";

import type { Judgement } from "../../api/generated";
import { whyRefused } from "../../api/refusal";
import { traceApi } from "../../api/traces";
import { decimal } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { can, useRun } from "../../session/run";
import { Button } from "../../ui/Button";
import { awaitAnswer } from "../../ui/effects";

interface Answer {
  run: string;
  said: readonly Judgement[];
  /** Why nothing is known. */
  wrong: string;
}

/** The answer of the studio about a run; null until it comes. */
function useJudgements(run: string, hasProperties: boolean): Answer | null {
  const [answer, setAnswer] = useState<Answer | null>(null);
  useEffect(() => {
    if (!hasProperties) return;
    return awaitAnswer(
      traceApi.judgements(run),
      (said) => setAnswer({ run, said, wrong: "" }),
      (cause) => setAnswer({ run, said: [], wrong: whyRefused(cause).message }),
    );
  }, [run, hasProperties]);
  return answer?.run === run ? answer : null;
}

export function RunJudgements({ children }: { children: ReactNode }) {
  const run = useRun((state) => state.name);
  const tickMs = useRun((state) => state.tickMs);
  const hasProperties = useRun(({ mission }) => (mission?.properties ?? []).length > 0);
  const seeks = useRun((state) => can("seek", state));
  const answer = useJudgements(run, hasProperties);
  if (!hasProperties || answer === null) return children;
  const { said, wrong } = answer;
  const kept = said.filter(({ ruling }) => ruling === "kept").length;
  return (
    <>
      {children}
      <div role="status" data-testid="run-judgements">
        {said
          .filter(({ ruling }) => ruling === "broken")
          .map(({ name, sentence, reason, tick }) => (
            <p key={name} title={reason} data-ruling="broken">
              <strong>
                {t("check.run-broken", { time: tick === null ? "" : `${decimal((tick * tickMs) / 1000, 1, 1)} s` })}
              </strong>{" "}
              <Said text={sentence} />{" "}
              {!seeks || tick === null ? null : (
                <Button testId={`judgement-${name}`} onClick={() => useRun.getState().seek(tick)}>
                  {t("check.run-where")}
                </Button>
              )}
            </p>
          ))}
        {said
          .filter(({ ruling }) => ruling === "not decided")
          .map(({ name, reason }) => (
            <p key={name} data-ruling="open">
              {t("check.run-open", { name })} <Said text={reason} />
            </p>
          ))}
        {kept === 0 ? null : <p data-ruling="kept">{t("check.run-kept", { count: kept })}</p>}
        {wrong === "" ? null : <p>{wrong}</p>}
      </div>
    </>
  );
}
