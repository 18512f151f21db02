/** The groups of the team: who is in each, and what happens when one of them fails. */
import { t } from "../../../i18n/words";
import { playing } from "../../../model/commands/castAgents";
import { addGroup, giveFailure, groupsOf, rolesOf } from "../../../model/commands/changeDeclared";
import { execute, useStudio } from "../../../model/studio";
import type { TeamGroup } from "../../../model/types";
import { Checkbox } from "../../../ui/Checkbox";
import { Chip } from "./Chip";
import { Card, freeDeclared } from "./parts";
import { placesSaid } from "./Roles";

const POLICIES = ["drop", "substitute", "abort"] as const;

function GroupCard({ group, at }: { group: TeamGroup; at: number }) {
  const mission = useStudio((studio) => studio.mission);
  const cast = playing(mission);
  const declared = new Set([...rolesOf(mission), ...groupsOf(mission)].map((one) => one.name));
  const { name, members, failure } = group;
  return (
    <Card
      name={name}
      icon="users"
      note={
        members.length === 1 && declared.has(members[0] ?? "") ? t("roster.chip-role", { name: members[0] ?? "" }) : ""
      }
      goal={{ kind: "group", name }}
      fields={null}
    >
      <div className="chips wrap flex gap-s">
        {members.map((member) => (
          <Chip
            key={member}
            thing={{ name: member, isAgent: !declared.has(member), from: name }}
            places={placesSaid(mission, member, cast.get(member))}
          />
        ))}
        <span className="chip-place finger row small-text muted slim gap-s justify-centre">{t("roster.drop")}</span>
      </div>
      <fieldset className="roster-card-policy column small-text">
        <legend>{t("roster.failure")}</legend>
        {POLICIES.map((policy) => (
          <Checkbox
            key={policy}
            className="finger"
            type="radio"
            name={`failure-${name}`}
            testId={`failure-${name}-${policy}`}
            checked={failure === policy}
            set={() => execute(giveFailure(useStudio.getState().mission, at, policy))}
          >
            {t(`roster.${policy}-policy`)}
          </Checkbox>
        ))}
      </fieldset>
    </Card>
  );
}

export function addedGroup(): string | null {
  const { mission } = useStudio.getState();
  const name = freeDeclared(t("roster.new-group"));
  const first = rolesOf(mission)[0]?.name ?? mission.agents[0]?.name ?? "";
  return execute(addGroup(mission, name, first)) ? name : null;
}

export function Groups() {
  const mission = useStudio((studio) => studio.mission);
  return groupsOf(mission).map((group, at) => <GroupCard key={at} group={group} at={at} />);
}
