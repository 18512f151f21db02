/** For whoever has no board at hand yet: which kit it will be, what that means for the program that is open, and its robot. */
import { listed, t } from "../../i18n/words";
import { changeRobot } from "../../model/commands/changeRobot";
import { robotKinds } from "../../model/robot-kinds";
import { execute, programInView, useStudio } from "../../model/studio";
import { TEAM_ROBOT } from "../../model/team-robot";
import { text } from "../../model/texts";
import { buildWith, suitedRobot, useKit } from "../../session/kit";
import { Button } from "../../ui/Button";
import { kitFor, useBoards } from "./boards";
import { askKit, knownKit, useKitsAt } from "./kits";

/** Start and Stop alone. */
const EMPTY = 2;

function takeRobot(robot: string): void {
  const { mission, catalogue, activeProgram } = useStudio.getState();
  execute(changeRobot(mission, catalogue, activeProgram, robot));
}

/** What was answered: a program without parts takes the robot that the kit can be most of. */
function takeKit(): void {
  const kit = knownKit(kitFor(useBoards.getState(), ""));
  buildWith(kit);
  const studio = useStudio.getState();
  const program = programInView(studio);
  if (kit === null || program === undefined || program.robot === TEAM_ROBOT) return;
  if (program.vertices.length <= EMPTY) takeRobot(suitedRobot(kit, studio.catalogue.robots, program.robot));
}

export function KitAtHand() {
  // Asked for here, so that the answer is known by its name.
  useKitsAt(useStudio((studio) => studio.file.path));
  const kit = useKit((state) => state.kit);
  const robot = useStudio((studio) => programInView(studio)?.robot ?? TEAM_ROBOT);
  const robots = useStudio((studio) => studio.catalogue.robots);
  const suited = kit === null || robot === TEAM_ROBOT ? robot : suitedRobot(kit, robots, robot);
  const label = robotKinds(robots).find(({ name }) => name === suited)?.label ?? suited;
  const objects = robots.find(({ name }) => name === robot)?.objects ?? [];
  const absent = (kit?.absent[robot] ?? []).map(({ category, name }) =>
    text(objects.find((one) => one.category === category && one.name === name)?.label ?? {}, name),
  );
  return (
    <div className="robots-kit column" data-testid="kit-at-hand" data-kit={kit?.name ?? ""}>
      <h3>{kit === null ? t("kits.no-board") : text(kit.label, kit.name)}</h3>
      <p className="muted">
        {kit === null || absent.length === 0 ? t("kits.no-board-help") : t("kits.absent", { parts: listed(absent) })}
      </p>
      <span className="row wrap">
        <Button testId="kit-pick" aria-haspopup="dialog" onClick={() => askKit("", takeKit)}>
          {t("kits.pick")}
        </Button>
        {kit === null ? null : (
          <Button testId="kit-all-parts" onClick={() => buildWith(null)}>
            {t("kits.all-parts")}
          </Button>
        )}
        {suited === robot ? null : (
          <Button testId="kit-take-robot" onClick={() => takeRobot(suited)}>
            {t("kits.take-robot", { robot: label })}
          </Button>
        )}
      </span>
    </div>
  );
}
