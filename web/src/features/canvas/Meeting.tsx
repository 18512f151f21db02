/** A meeting at which members of a team wait: "2 of 3 are here; carrier-2 is missing". */
import type { Meeting as TeamMeeting } from "../../api/generated";
import { meetingSaid } from "../../session/meetings";
import { Icon } from "../../theme";
import "./meeting.css";

export function Meeting({ meeting }: { meeting: TeamMeeting }) {
  return (
    <span className="meeting row nowrap gap-s passive" data-testid="meeting" role="note">
      <Icon name="hourglass" size={12} />
      {meetingSaid(meeting)}
    </span>
  );
}
