/** The "+" after the tabs: a new program, for one of the robots that there are. */
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { TEAM_ROBOT } from "../model/team-robot";
import { text } from "../model/texts";
import { addProgramFor } from "../session/actions";
import { complain } from "../session/document";
import { Icon } from "../theme";
import { type MenuEntry, menuItem } from "../ui/menu-model";
import { MenuButton } from "../ui/MenuButton";

/** The robots as entries of a menu. */
export function robotEntries(robots: readonly { name: string; label: Record<string, string> }[]): MenuEntry[] {
  const kinds = robots.filter(({ name }) => name !== TEAM_ROBOT);
  const labels = kinds.map(({ name, label }) => text(label, name));
  return kinds.map(({ name }, at) => {
    const label = labels[at] ?? name;
    // A copy of a robot that kept its label is told from it by its name.
    const alone = labels.indexOf(label) === labels.lastIndexOf(label);
    return menuItem(`add-${name}`, alone ? label : `${label} (${name})`, null, () => addProgramFor(name));
  });
}

/** A program of the whole team; where there is one, of a group. */
function teamEntry(social: boolean): MenuEntry {
  const add = (what: "startTeam" | "addGroupProgram") => () => {
    import("../session/first-team").then((team) => team[what]()).catch(complain);
  };
  return social
    ? menuItem("add-group-program", t("first-team.group"), null, add("addGroupProgram"))
    : menuItem("add-team-program", t("first-team.social"), null, add("startTeam"));
}

export function AddProgram() {
  const social = useStudio((studio) => studio.mission.programs.some((one) => one.level === "social"));
  const robots = useStudio((studio) => studio.catalogue.robots);
  if (robots.length === 0) return null;
  return (
    <span className="add-program">
      <MenuButton
        id="add-program"
        label={t("tabs.add")}
        aria-label={t("tabs.add")}
        className="tool"
        entries={[
          { kind: "heading", id: "for", label: t("program.add") },
          ...robotEntries(robots),
          { kind: "line", id: "team" },
          teamEntry(social),
        ]}
      >
        <Icon name="plus" size={18} />
      </MenuButton>
    </span>
  );
}
