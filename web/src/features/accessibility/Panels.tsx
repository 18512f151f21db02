/** What makes the studio reachable for everyone, beside the page itself: announcements, the outline, help for a part. */
import { complain } from "../../session/document";
import { later } from "../../ui/later";
import { Announcer } from "./Announcer";
import { useAccessibility } from "./state";

const Outline = later(() => import("./Outline").then((chunk) => chunk.Outline), complain);
const PartHelp = later(() => import("./PartHelp").then((chunk) => chunk.PartHelp), complain);

export function Panels() {
  const outline = useAccessibility((state) => state.outline);
  const explained = useAccessibility((state) => state.explained !== null);
  return (
    <>
      <Announcer />
      {outline ? <Outline /> : null}
      {explained ? <PartHelp /> : null}
    </>
  );
}
