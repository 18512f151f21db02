/** The button of the members in the bottom bar, while a team's program runs, and their list above, fetched when it opens. */
import { t } from "../../i18n/words";
import { complain } from "../../session/document";
import { showMembers, useMembers } from "../../session/members";
import { useRun } from "../../session/run";
import { DockButton } from "../../ui/DockButton";
import { later } from "../../ui/later";

const Members = later(() => import("./Members").then((chunk) => chunk.Members), complain);

export function MembersButton() {
  const there = useRun((run) => run.team !== null);
  const open = useMembers((members) => members.open);
  if (!there) return null;
  return (
    <DockButton
      icon="users"
      testId="members-button"
      open={open}
      panel="members-panel"
      onPress={() => showMembers(!open)}
    >
      {t("members.title")}
    </DockButton>
  );
}

export function MembersDock() {
  const there = useRun((run) => run.team !== null);
  const open = useMembers((members) => members.open);
  return open && there ? <Members /> : null;
}
