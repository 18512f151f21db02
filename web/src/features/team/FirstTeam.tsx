/** What a team's program is, and a first one to begin with, where the mission has none. */
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { startTeam } from "../../session/first-team";
import { useShown } from "../../session/simple-view";
import { Button } from "../../ui/Button";

export function FirstTeam() {
  const there = useStudio((studio) => studio.mission.programs.some((one) => one.level === "social"));
  const shown = useShown("team");
  if (there || !shown) return null;
  return (
    <section className="team-part surface" aria-labelledby="first-team" data-testid="first-team">
      <h2 id="first-team">{t("first-team.title")}</h2>
      <p className="team-note muted">{t("first-team.what")}</p>
      <p className="row wrap">
        <Button icon="users" testId="start-team" onClick={() => void startTeam()}>
          {" "}
          {t("first-team.start")}
        </Button>
        <span>{t("first-team.start-help")}</span>
      </p>
    </section>
  );
}
