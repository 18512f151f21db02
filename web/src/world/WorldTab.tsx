/** The tab behind the team's, and the panel that it opens: the world, fetched when somebody opens it. */
import { type KeyboardEvent, lazy, Suspense } from "react";

import { useStudio } from "../model/studio";
import { thingNamed } from "../model/world/thing";
import { useTeam } from "../team/view";
import { Icon } from "../theme";
import { t } from "../words/words";
import { openWorld } from "./state";

const World = lazy(() => import("./World"));

export function WorldTab({ onKey }: { onKey: (event: KeyboardEvent) => void }) {
  const open = useTeam((team) => team.world);
  const errors = useStudio((studio) =>
    studio.report?.problems.some(
      (one) => one.severity === "error" && thingNamed(studio.mission.own_world, one.thing) !== null,
    ),
  );
  return (
    <button
      type="button"
      role="tab"
      className="tab tab-world"
      id="tab-of-world"
      title={t("world.tab")}
      data-testid="tab-of-world"
      aria-selected={open}
      {...(open ? { "aria-controls": "world-panel" } : {})}
      tabIndex={open ? 0 : -1}
      onClick={() => openWorld()}
      onKeyDown={onKey}
    >
      <Icon name="map" size={16} />
      <span className="tab-name">{t("world.tab")}</span>
      {errors === true ? <Icon name="circle-x" size={14} label={t("problems.error")} className="tab-error" /> : null}
    </button>
  );
}

/** The world over the canvas, which stays as it is underneath. */
export function WorldPanel() {
  const open = useTeam((team) => team.world);
  if (!open) return null;
  return (
    <Suspense fallback={null}>
      <World />
    </Suspense>
  );
}
