/** What makes the studio reachable for everyone, beside the page itself: announcements, the outline, help for a part. */
import { Announcer } from "./Announcer";
import { Outline } from "./Outline";
import { PartHelp } from "./PartHelp";
import "./reach.css";
import "./touch.css";

export function Reach() {
  return (
    <>
      <Announcer />
      <Outline />
      <PartHelp />
    </>
  );
}
