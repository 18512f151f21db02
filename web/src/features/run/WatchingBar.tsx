/** Across the page: a run of this mission goes on in another window and can be watched, or is watched. */
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useRun } from "../../session/run";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";

export function WatchingBar({ run }: { run: string }) {
  const watching = useRun((state) => state.watching);
  const another = useRun((state) => state.another);
  return (
    <div
      className="banner banner-note row rigid gap-xl"
      role="status"
      data-testid="watching-bar"
      data-watching={watching}
    >
      <Icon name="eye" size={18} />
      <p>
        <strong>{t(watching ? "watching.on" : "watching.offer")}</strong>{" "}
        {watching && another ? t("watching.another") : null}
      </p>
      {watching ? (
        <Button testId="watch-leave" onClick={useRun.getState().reset}>
          {t("watching.leave")}
        </Button>
      ) : (
        <Button
          testId="watch-run"
          onClick={() => useRun.getState().watch({ mission: useStudio.getState().mission, run })}
        >
          {t("watching.watch")}
        </Button>
      )}
    </div>
  );
}
