/** Which parts of its robot a program names. */
import { ownConstructors } from "./own-parts";
import type { Mission } from "./types";

/** Whether a program names a part: in a vertex, in a number of one, or in a constructor that the mission brings along. */
export function namesPart(mission: Mission, program: string, part: string): boolean {
  const call = `${part}.`;
  const vertices = mission.programs.find((one) => one.name === program)?.vertices ?? [];
  return (
    vertices.some(
      ({ element, settings }) =>
        element.startsWith(call) || Object.values(settings).some((value) => String(value).includes(call)),
    ) || JSON.stringify(ownConstructors(mission)).includes(call)
  );
}
