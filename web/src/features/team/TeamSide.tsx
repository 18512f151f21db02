/** Where the parts are: a switch between them and the team, in missions that have programs of one. */
import "./side.css";

import type { ReactNode } from "react";

import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { TEAM_ROBOT } from "../../model/team-robot";
import { reportError } from "../../session/document";
import { showSide, type TeamSide as Side, useTeam } from "../../session/team-view";
import { Icon } from "../../theme";
import { later } from "../../ui/later";
import { TabList } from "../../ui/TabList";

const Roster = later(() => import("./roster/Roster").then((chunk) => chunk.default), reportError);

const SIDES: readonly Side[] = ["team", "parts"];

export function TeamSide({ children }: { children: ReactNode }) {
  const there = useStudio((studio) => studio.mission.programs.some((one) => one.robot === TEAM_ROBOT));
  const side = useTeam((team) => team.side);
  if (!there) return children;
  return (
    <>
      <TabList
        label={t("roster.label")}
        id="side"
        names={SIDES}
        open={side}
        show={showSide}
        controls="side-panel"
        className="team-side"
        tabClass="finger row gap-s small-text medium muted"
      >
        {(one) => (
          <>
            <Icon name={one === "team" ? "users" : "boxes"} size={16} />
            {t(`roster.${one}`)}
          </>
        )}
      </TabList>
      <div id="side-panel" role="tabpanel" aria-labelledby={`side-${side}`}>
        {side === "team" ? <Roster /> : children}
      </div>
    </>
  );
}
