/** The roles of the team, who plays each, and who plays none. */
import { t } from "../../../i18n/words";
import { isOfTeam, playing } from "../../../model/commands/castAgents";
import { addRole, changeRole, groupsOf, rolesOf } from "../../../model/commands/changeDeclared";
import { execute, useStudio } from "../../../model/studio";
import { TEAM_ROBOT } from "../../../model/team-robot";
import { text } from "../../../model/texts";
import type { Mission, Role } from "../../../model/types";
import { Select } from "../../../ui/Select";
import { Chip, useOver } from "./Chip";
import { Card, Count, freeDeclared, MOST } from "./parts";

export function wantedOf({ least, most }: Pick<Role, "least" | "most">): string {
  return least === most ? String(most) : t("roster.or-more", { least: String(least), most: String(most) });
}

/** Where an agent is, in words. */
export function placesSaid(mission: Mission, name: string, role: string | undefined): string {
  const groups = groupsOf(mission).filter(({ members }) => members.includes(name));
  const places = [
    role === undefined ? t("roster.spare") : t("roster.chip-role", { name: role }),
    ...groups.map((group) => t("roster.in-group", { name: group.name })),
  ];
  return places.join(", ");
}

function RoleCard({ role, at, players }: { role: Role; at: number; players: readonly string[] }) {
  const mission = useStudio((studio) => studio.mission);
  const robots = useStudio((studio) => studio.catalogue.robots);
  const change = (what: Parameters<typeof changeRole>[2]) =>
    execute(changeRole(useStudio.getState().mission, at, what));
  const { name } = role;
  return (
    <Card
      name={name}
      icon="user-check"
      note={t("roster.of", { count: players.length, wanted: wantedOf(role) })}
      goal={{ kind: "role", name }}
      fields={
        <>
          <Select
            label={t("roster.robot-of", { name })}
            testId={`robot-${name}`}
            value={role.robot}
            options={robots
              .filter((one) => one.name !== TEAM_ROBOT)
              .map((one) => [one.name, text(one.label, one.name)])}
            missing={t("roster.no-robot", { robot: role.robot })}
            keep={(robot) => change({ robot })}
          />
          <div className="roster-card-counts gap-s">
            <Count
              label={t("roster.least")}
              testId={`least-${name}`}
              value={role.least}
              min={0}
              max={MOST}
              keep={(least) => change({ least })}
            />
            <Count
              label={t("roster.most")}
              testId={`most-${name}`}
              value={role.most}
              min={1}
              max={MOST}
              keep={(most) => change({ most })}
            />
          </div>
        </>
      }
    >
      <div className="chips wrap flex gap-s">
        {players.map((agent) => (
          <Chip key={agent} thing={{ name: agent, isAgent: true }} places={placesSaid(mission, agent, name)} />
        ))}
        {players.length < role.most ? (
          <span className="chip-place finger row small-text muted slim gap-s justify-centre">{t("roster.drop")}</span>
        ) : null}
      </div>
    </Card>
  );
}

/** The kind of robot that a new role is for: one that no role is for yet, as far as there is one. */
function kindWanted({ agents, programs, roles = [] }: Mission): string {
  const kinds = [...agents.map((one) => one.robot ?? ""), ...programs.map((one) => one.robot)].filter(
    (kind) => kind !== "",
  );
  const robots = useStudio.getState().catalogue.robots.map((one) => one.name);
  return kinds.find((kind) => roles.every((role) => role.robot !== kind)) ?? kinds[0] ?? robots[0] ?? "";
}

export function addedRole(): string | null {
  const { mission } = useStudio.getState();
  const name = freeDeclared(t("roster.new-role"));
  return execute(addRole(mission, name, kindWanted(mission))) ? name : null;
}

export function Roles() {
  const mission = useStudio((studio) => studio.mission);
  const cast = playing(mission);
  const team = mission.agents.filter((one) => isOfTeam(mission, one)).map((one) => one.name);
  return rolesOf(mission).map((role, at) => (
    <RoleCard key={at} role={role} at={at} players={team.filter((name) => cast.get(name) === role.name)} />
  ));
}

/** Robots without a role: spare ones, and those that are not of the team. */
export function Spare() {
  const mission = useStudio((studio) => studio.mission);
  const { over, why } = useOver({ kind: "spare", name: "" });
  const cast = playing(mission);
  const spare = mission.agents.filter((one) => isOfTeam(mission, one) && !cast.has(one.name));
  const others = mission.agents.filter((one) => !isOfTeam(mission, one));
  const row = (agents: typeof others, title: string, help: string) => (
    <>
      <div className="roster-card-head row gap-s">
        <strong>{title}</strong>
        <small>{help}</small>
      </div>
      <div className="chips wrap flex gap-s">
        {agents.map(({ name }) => (
          <Chip key={name} thing={{ name, isAgent: true }} places={placesSaid(mission, name, undefined)} />
        ))}
        {agents.length === 0 ? (
          <span className="chip-place finger row small-text muted slim gap-s justify-centre">{t("roster.drop")}</span>
        ) : null}
      </div>
    </>
  );
  return (
    <div
      className="roster-card roster-card-spare surface column"
      data-testid="card-spare"
      data-goal="spare"
      data-name=""
      data-over={over ? (why === "" ? "takes" : "refuses") : undefined}
    >
      {row(spare, t("roster.spare"), t("roster.spare-help"))}
      {others.length === 0 ? null : row(others, t("roster.others"), t("roster.others-help"))}
      {over && why !== "" ? (
        <p className="roster-card-why small-text" role="status">
          {why}
        </p>
      ) : null}
    </div>
  );
}
