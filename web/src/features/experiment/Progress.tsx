/** How far the work on a study is, and what is left of it. */
import { clock, grouped } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { Button } from "../../ui/Button";
import { breakOff } from "./study-work";

export function Progress({ done, total, left }: { done: number; total: number; left: number | null }) {
  const said =
    total === 0 ? t("experiment.preparing") : t("experiment.progress", { done: grouped(done), total: grouped(total) });
  return (
    <div className="experiment-progress column gap-m items-start" data-testid="experiment-progress">
      <progress aria-label={said} max={Math.max(total, 1)} {...(total === 0 ? {} : { value: done })} />
      <p className="figures">
        {said}
        {left === null || done >= total ? null : (
          <span className="muted"> {t("experiment.left", { time: clock(left) })}</span>
        )}
      </p>
      <Button icon="square" testId="experiment-break-off" onClick={breakOff}>
        {t("experiment.break-off")}
      </Button>
    </div>
  );
}
