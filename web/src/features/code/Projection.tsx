/**
 * What the program of the whole team is for each kind of robot: LLL that is read, not written, as the newest check says it.
 *
 * A line shows its vertex, in whichever program that stands; selected vertices show their lines. Fetched when it is opened.
 */
import { useCallback, useMemo, useState } from "react";

import { lllExtensions } from "../../components/text/extensions";
import { TextView } from "../../components/text/TextView";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { Mission, Projection as Projected } from "../../model/types";
import { useBehind } from "../../session/report";
import { spansInUnits } from "../../session/places";
import { closeTeam } from "../../session/team-view";
import { useView } from "../../session/view";
import { Icon } from "../../theme";
import { TabList } from "../../ui/TabList";
import { vertexAt } from "./spans";
import "./projection.css";

const NOWHERE: ReadonlyMap<number, number[]> = new Map();
const NONE: readonly Projected[] = [];

/** A kind of robot and the roles that it plays. */
function tabName(robot: string, { roles = [] }: Mission): string {
  const names = roles.filter((role) => role.robot === robot).map((role) => role.name);
  return names.length === 0 ? robot : names.join(", ");
}

function Text({ projection }: { projection: Projected }) {
  const program = useStudio((studio) => studio.activeProgram);
  const selection = useStudio((studio) => studio.selection);
  const text = projection.lll.trimEnd();
  const spans = useMemo(() => spansInUnits(projection.spans, text), [projection, text]);
  const shown = useMemo(
    () => ({
      active: NOWHERE,
      selected: spans.filter((span) => span.program === program && selection.includes(span.vertex)),
    }),
    [spans, program, selection],
  );
  const onPick = useCallback(
    (offset: number, byMouse: boolean) => {
      const line = text.slice(0, offset).split("\n").length;
      const vertex = vertexAt(spans, offset);
      const span =
        spans.find((one) => one.vertex === vertex && one.line === line) ?? spans.find((one) => one.line === line);
      if (span === undefined) return;
      const { activeProgram, setActiveProgram, select } = useStudio.getState();
      if (span.program !== activeProgram) {
        // The arrows walk the text; only a click leaves the program for another.
        if (!byMouse) return;
        closeTeam();
        setActiveProgram(span.program);
      }
      select([span.vertex]);
      useView.getState().viewport?.reveal(span.vertex);
    },
    [spans, text],
  );
  return (
    <TextView
      text={text}
      label={t("projection.label", { robot: projection.robot })}
      extensions={lllExtensions}
      shown={shown}
      onPick={onPick}
    />
  );
}

export default function Projection() {
  const projections = useStudio((studio) => studio.report?.projections ?? NONE);
  const mission = useStudio((studio) => studio.mission);
  const behind = useBehind();
  const [wanted, setWanted] = useState("");
  const shown = projections.find((one) => one.robot === wanted) ?? projections[0];
  if (shown === undefined) {
    const social = mission.programs.some((one) => one.level === "social");
    const why = !social ? "projection.no-social" : behind ? "projection.waits" : "projection.none";
    return (
      <p className="projection-none muted" role="status" data-testid="projection-none">
        {t(why)}
      </p>
    );
  }
  return (
    <div className="projection column" data-testid="projection">
      <div className="projection-head row small-text between gap-xl">
        <TabList
          label={t("projection.kinds")}
          id="projection"
          names={projections.map(({ robot }) => robot)}
          open={shown.robot}
          show={setWanted}
          controls="projection-text"
          className="side-tablist flex slim gap-2xl"
          tabClass="side-tab ellipsis muted focus-inside"
          title={(robot) => robot}
        >
          {(robot) => <bdi>{tabName(robot, mission)}</bdi>}
        </TabList>
        <small className="row muted rigid tiny-text gap-xs">
          <Icon name="eye" size={14} /> {t("projection.read-only")}
        </small>
      </div>
      <div
        className="fill"
        id="projection-text"
        role="tabpanel"
        aria-labelledby={`projection-${shown.robot}`}
        aria-busy={behind}
      >
        <Text projection={shown} />
      </div>
    </div>
  );
}
