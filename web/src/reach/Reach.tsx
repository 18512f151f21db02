/** What makes the studio reachable for everyone, beside the page itself: announcements, the outline, help for a part. */
import { useEffect } from "react";

import { Announcer } from "./Announcer";
import { Outline } from "./Outline";
import { PartHelp } from "./PartHelp";
import "./reach.css";
import { closeHelp, explain, toggleOutline, useReach } from "./state";

/** F1 explains a part, F4 opens the outline; from anywhere, fields included. */
function useReachKeys(): void {
  useEffect(() => {
    const onKeyDown = (event: KeyboardEvent) => {
      if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) return;
      if (event.key === "F1") explain();
      else if (event.key === "F4") toggleOutline();
      else if (event.key === "Escape" && useReach.getState().explained !== null) closeHelp();
      else return;
      event.preventDefault();
    };
    window.addEventListener("keydown", onKeyDown);
    return () => {
      window.removeEventListener("keydown", onKeyDown);
    };
  }, []);
}

export function Reach() {
  useReachKeys();
  return (
    <>
      <Announcer />
      <Outline />
      <PartHelp />
    </>
  );
}
