/** The place of the panel: where the arena stands, which comes back when the panel is closed. */
import { Arena } from "../arena/Arena";
import { complain } from "../shell/document";
import { later } from "../shell/later";
import { showRobots, useRobotsPanel } from "./state";

const Robots = later(
  () => import("./Robots").then((chunk) => chunk.Robots),
  (cause) => {
    showRobots(false);
    complain(cause);
  },
);

export function ArenaOrRobots() {
  const open = useRobotsPanel((state) => state.open);
  return open ? <Robots /> : <Arena />;
}
