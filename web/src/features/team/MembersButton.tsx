/** The button of the members in the bottom bar, while a team's program runs. */
import { DockButton } from "../../components/DockButton";
import { t } from "../../i18n/words";
import { MEMBERS } from "../../session/members";
import { useRun } from "../../session/run";

export function MembersButton() {
  const there = useRun((run) => run.team !== null);
  if (!there) return null;
  return (
    <DockButton icon="users" testId="members-button" panel={MEMBERS}>
      {t("members.title")}
    </DockButton>
  );
}
