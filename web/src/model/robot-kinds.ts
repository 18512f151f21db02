/** The kinds of robots that there are to choose from, each with a label that no other one has. */
import { TEAM_ROBOT } from "./team-robot";
import { text } from "./texts";
import type { Robot } from "./types";

export interface RobotKind {
  name: string;
  label: string;
}

export function robotKinds(robots: readonly Pick<Robot, "name" | "label">[]): RobotKind[] {
  const kinds = robots.filter(({ name }) => name !== TEAM_ROBOT);
  const labels = kinds.map(({ name, label }) => text(label, name));
  return kinds.map(({ name }, at) => {
    const label = labels[at] ?? name;
    // A copy of a robot that kept its label is told from it by its name.
    const alone = labels.indexOf(label) === labels.lastIndexOf(label);
    return { name, label: alone ? label : `${label} (${name})` };
  });
}
