/** The "+" after the tabs: a new program, for one of the robots that there are. */
import { t } from "../i18n/words";
import { robotKinds } from "../model/robot-kinds";
import { useStudio } from "../model/studio";
import { addProgramFor } from "../session/actions";
import { reportError } from "../session/document";
import { useShown } from "../session/simple-view";
import { Icon } from "../theme";
import { type MenuEntry, menuItem } from "../ui/menu-model";
import { MenuButton } from "../ui/MenuButton";

/** The robots as entries of a menu. */
export function robotEntries(robots: Parameters<typeof robotKinds>[0]): MenuEntry[] {
  return robotKinds(robots).map(({ name, label }) => menuItem(`add-${name}`, label, null, () => addProgramFor(name)));
}

/** A program of the whole team; where there is one, of a group. */
function teamEntry(social: boolean): MenuEntry {
  const add = (what: "startTeam" | "addGroupProgram") => () => {
    import("../session/first-team").then((team) => team[what]()).catch(reportError);
  };
  return social
    ? menuItem("add-group-program", t("first-team.group"), null, add("addGroupProgram"))
    : menuItem("add-team-program", t("first-team.social"), null, add("startTeam"));
}

export function AddProgram() {
  const social = useStudio((studio) => studio.mission.programs.some((one) => one.level === "social"));
  const team = useShown("team");
  const robots = useStudio((studio) => studio.catalogue.robots);
  if (robots.length === 0) return null;
  return (
    <span className="add-program rigid aligned">
      <MenuButton
        id="add-program"
        label={t("tabs.add")}
        aria-label={t("tabs.add")}
        className="tool rigid"
        entries={[
          { kind: "heading", id: "for", label: t("program.add") },
          ...robotEntries(robots),
          ...(team ? [{ kind: "line", id: "team" } as const, teamEntry(social)] : []),
        ]}
      >
        <Icon name="plus" size={18} />
      </MenuButton>
    </span>
  );
}
