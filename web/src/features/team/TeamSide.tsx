/** Where the parts are: a switch between them and the team, in missions that have programs of one. */
import { type KeyboardEvent, type ReactNode, useRef } from "react";

import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { TEAM_ROBOT } from "../../model/team-robot";
import { complain } from "../../session/document";
import { showSide, type TeamSide as Side, useTeam } from "../../session/team-view";
import { Icon } from "../../theme";
import { later } from "../../ui/later";
import "./side.css";

const Roster = later(() => import("./roster/Roster").then((chunk) => chunk.default), complain);

const SIDES: readonly Side[] = ["team", "parts"];

export function TeamSide({ children }: { children: ReactNode }) {
  const there = useStudio((studio) => studio.mission.programs.some((one) => one.robot === TEAM_ROBOT));
  const side = useTeam((team) => team.side);
  const row = useRef<HTMLDivElement>(null);
  if (!there) return children;
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
    event.preventDefault();
    showSide(side === "team" ? "parts" : "team");
    requestAnimationFrame(() => row.current?.querySelector<HTMLElement>('[aria-selected="true"]')?.focus());
  };
  return (
    <>
      <div className="team-side" role="tablist" aria-label={t("roster.label")} ref={row} onKeyDown={onKey}>
        {SIDES.map((one) => (
          <button
            key={one}
            type="button"
            role="tab"
            id={`side-tab-${one}`}
            data-testid={`side-${one}`}
            aria-selected={side === one}
            aria-controls="side-panel"
            tabIndex={side === one ? 0 : -1}
            onClick={() => showSide(one)}
          >
            <Icon name={one === "team" ? "users" : "boxes"} size={16} />
            {t(`roster.${one}`)}
          </button>
        ))}
      </div>
      <div id="side-panel" role="tabpanel" aria-labelledby={`side-tab-${side}`}>
        {side === "team" ? <Roster /> : children}
      </div>
    </>
  );
}
