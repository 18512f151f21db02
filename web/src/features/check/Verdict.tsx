/** The check in a sentence, and what its answers take for granted. */
import type { VerifyColumnMessage } from "../../api/generated";
import { t } from "../../i18n/words";
import { Said } from "../../i18n/Said";
import { USUAL, withKinds } from "./kinds";
import type { Assumption } from "./table";
import { begin, useCheck } from "./check-session";
import { Button } from "../../ui/Button";

const MOST_FAILURES = 3;

/** "prompt, up to 2 failures" */
export function assumptionWords({ timing, failures }: Assumption): string {
  const name = t(`check.${timing}`);
  if (failures === 0) return name;
  const kinds = useCheck.getState().asked?.kinds ?? USUAL;
  return withKinds(t("check.with-failures", { timing: name, count: failures }), kinds);
}

/** That nothing is broken as far as it was looked at, and what helps to look further. */
function cutWords(columns: readonly VerifyColumnMessage[]): string {
  if (columns.some((column) => column.is_approximate)) return t("check.rough-verdict");
  const why = columns.map(({ cut }) => cut).filter((cut) => cut !== null);
  const helps = why.includes("memory")
    ? t("check.less")
    : why.every((cut) => cut === "time")
      ? t("check.more-time")
      : "";
  return `${t("check.cut")} ${helps}`.trim();
}

/** What came of the check: how many are broken, whether all hold, and what was not reached. */
export function Verdict() {
  const asked = useCheck((check) => check.asked);
  const busy = useCheck((check) => check.busy);
  const columns = useCheck((check) => check.columns);
  const planned = useCheck((check) => check.plan.length);
  const answers = columns.flatMap((column) => column.properties);
  const broken = new Set(answers.filter(({ answer }) => answer === "broken").map(({ name }) => name)).size;
  const cut = answers.some(({ answer }) => answer !== "holds" && answer !== "vacuous") || columns.length < planned;
  if (asked === null || (busy && broken === 0)) return null;
  const words = broken > 0 ? t("check.broken-count", { count: broken }) : cut ? cutWords(columns) : t("check.all-hold");
  const most = asked.failures ?? 0;
  return (
    <p className="check-verdict row wrap" role="status" data-testid="check-verdict">
      <strong>{words}</strong>
      {broken === 0 && !cut && most < MOST_FAILURES ? (
        <Button
          icon="plus"

          testId="check-more-failures"
          onClick={() => begin(most + 1, asked.kinds ?? USUAL, asked.seconds, asked.approximate ?? false)}
        >
          {t("check.let-fail", { count: most + 1 })}
        </Button>
      ) : null}
    </p>
  );
}

export function Limits() {
  const limits = useCheck((check) => check.limits);
  if (limits === null || limits.length === 0) return null;
  return (
    <details className="check-limits muted small-text" data-testid="check-limits">
      <summary>{t("check.limits", { count: limits.length })}</summary>
      <ul>
        {limits.map((limit) => (
          <li key={limit}>
            <Said text={limit} />
          </li>
        ))}
      </ul>
    </details>
  );
}
