/** Across the page: what is shown of real robots is their past. They go on meanwhile, and so can what is shown. */
import { clock } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { useRun } from "../../session/run";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";

export function BehindBar() {
  const time = useRun((run) => clock(run.seconds));
  const watching = useRun((run) => run.watching);
  return (
    <div className="banner banner-note row rigid gap-xl" data-testid="behind-bar">
      <Icon name="radio" size={18} />
      <p>{t("robots.behind", { time })}</p>
      {watching ? null : (
        <Button icon="play" testId="follow" onClick={useRun.getState().follow}>
          {t("robots.now")}
        </Button>
      )}
    </div>
  );
}
