/** The tab behind those of the programs, and the panel that it opens. */
import { type KeyboardEvent, lazy, Suspense } from "react";

import { useStudio } from "../model/studio";
import { Icon } from "../theme";
import { t } from "../words/words";
import { openTeam, teamPlace, useTeam } from "./view";

const Team = lazy(() => import("./Team"));

export function TeamTab({ onKey }: { onKey: (event: KeyboardEvent) => void }) {
  const open = useTeam((team) => team.open);
  const count = useStudio((studio) => studio.mission.agents.length);
  const errors = useStudio((studio) =>
    studio.report?.problems.some((one) => one.severity === "error" && teamPlace(one, studio.mission) !== null),
  );
  return (
    <button
      type="button"
      role="tab"
      className="tab tab-team"
      id="tab-of-team"
      title={t("team.tab")}
      data-testid="tab-of-team"
      aria-selected={open}
      {...(open ? { "aria-controls": "team-panel" } : {})}
      tabIndex={open ? 0 : -1}
      onClick={() => openTeam()}
      onKeyDown={onKey}
    >
      <Icon name="users" size={16} />
      <span className="tab-name">{t("team.tab")}</span>
      <span className="tab-count" aria-label={t("tabs.agents", { count })}>
        {count}
      </span>
      {errors === true ? <Icon name="circle-x" size={14} label={t("problems.error")} className="tab-error" /> : null}
    </button>
  );
}

/** The team over the canvas, which stays as it is underneath. */
export function TeamPanel() {
  const open = useTeam((team) => team.open);
  if (!open) return null;
  return (
    <Suspense fallback={null}>
      <Team />
    </Suspense>
  );
}
