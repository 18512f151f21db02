/** The world that states of a mission are drawn in. */
import { useStudio } from "../../model/studio";
import type { Mission, World } from "../../model/types";
import { drawnWorld } from "../../model/world/drawing";

/** The mission's own world, else the one that the page has read; null where there is none yet. */
export function useWorldOf(mission: Mission): World | null {
  const read = useStudio((studio) => studio.world);
  return mission.own_world == null ? read : drawnWorld(mission.own_world);
}
