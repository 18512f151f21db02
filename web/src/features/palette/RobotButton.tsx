/** The robot that the program is for, above its parts: a button with the robots that there are. */
import { t } from "../../i18n/words";
import { robotKinds } from "../../model/robot-kinds";
import { execute, programInView, useStudio } from "../../model/studio";
import { TEAM_ROBOT } from "../../model/team-robot";
import { reportError } from "../../session/document";
import { Icon } from "../../theme";
import { later } from "../../ui/later";
import type { MenuEntry } from "../../ui/menu-model";
import { MenuButton } from "../../ui/MenuButton";

const RobotPicture = later(
  () => import("../../components/RobotPicture").then((chunk) => chunk.RobotPicture),
  reportError,
  { words: false },
);

function takeRobot(robot: string): void {
  import("../../model/commands/changeRobot").then(({ changeRobot }) => {
    const { mission, catalogue, activeProgram } = useStudio.getState();
    execute(changeRobot(mission, catalogue, activeProgram, robot));
  }, reportError);
}

/** Nothing in a program of a team, whose parts are those of several robots. */
export function RobotButton() {
  const robot = useStudio((studio) => programInView(studio)?.robot ?? TEAM_ROBOT);
  const robots = useStudio((studio) => studio.catalogue.robots);
  if (robot === TEAM_ROBOT) return null;
  const kinds = robotKinds(robots);
  const entries = kinds.map(({ name, label }): MenuEntry => ({
    kind: "radio",
    id: `robot-${name}`,
    label,
    checked: name === robot,
    picture: <RobotPicture kind={name} index={0} />,
    run: () => takeRobot(name),
  }));
  return (
    <MenuButton
      id="palette-robot"
      label={t("parts.change-robot")}
      className="palette-robot row bold rigid start-text boxed"
      entries={entries}
    >
      <span className="palette-name grow breakable">{kinds.find(({ name }) => name === robot)?.label ?? robot}</span>
      <Icon name="chevron-down" size={14} />
    </MenuButton>
  );
}
