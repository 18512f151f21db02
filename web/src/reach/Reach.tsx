/** What makes the studio reachable for everyone, beside the page itself: announcements, the outline, help for a part. */
import { Announcer } from "./Announcer";
import { complain } from "../shell/document";
import { later } from "../shell/later";
import { useReach } from "./state";
import "./reach.css";
import "./touch.css";

const Outline = later(() => import("./Outline").then((chunk) => chunk.Outline), complain);
const PartHelp = later(() => import("./PartHelp").then((chunk) => chunk.PartHelp), complain);

export function Reach() {
  const outline = useReach((state) => state.outline);
  const explained = useReach((state) => state.explained !== null);
  return (
    <>
      <Announcer />
      {outline ? <Outline /> : null}
      {explained ? <PartHelp /> : null}
    </>
  );
}
