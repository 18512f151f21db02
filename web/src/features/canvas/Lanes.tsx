/** Lanes of a team's program: who acts in each branch of a parallel, and while it runs, which robots these are. */
import type { TeamNow } from "../../api/generated";
import { LANE, type LayoutLane } from "../../model/layout";
import { useRun } from "../../session/run";
import "./lanes.css";

/**
 * The robots of a team that play what stands in a lane, "carrier-4 (carrier-2)" where one took over for another: what is
 * meant for an agent is done by the one that stands for it. A role that robots move from or to is a group.
 */
export function playing(names: readonly string[], team: TeamNow | null): string {
  const members = team?.members ?? [];
  const groups = new Set(team?.groups);
  return members
    .filter(
      ({ name, role, groups: own, stands_for }) =>
        role !== "" &&
        names.some((one) =>
          groups.has(one) ? own.includes(one) : one === role || one === (stands_for === "" ? name : stands_for),
        ),
    )
    .map(({ name, stands_for }) => (stands_for === "" || stands_for === name ? name : `${name} (${stands_for})`))
    .join(", ");
}

export function Lane({ lane: { x, y, w, h, names, first } }: { lane: LayoutLane }) {
  const robots = useRun(({ team }) => playing(names, team));
  return (
    <div className="lane" data-testid="lane" data-first={first} style={{ left: x, top: y, width: w, height: h }}>
      <p className="lane-head row bold justify-centre" style={{ height: LANE }}>
        <bdi>{names.join(", ")}</bdi> {robots === "" ? null : <bdi className="lane-robots">{robots}</bdi>}
      </p>
    </div>
  );
}

export function Lanes({ lanes }: { lanes: readonly LayoutLane[] }) {
  return lanes.map((lane) => <Lane key={lane.id} lane={lane} />);
}
