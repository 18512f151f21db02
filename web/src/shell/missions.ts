/** The missions that can be opened, asked for when somebody wants to see them. */
import { useEffect, useState } from "react";

import { api, type MissionEntry } from "../api/client";
import { complain } from "./document";

/** null while the list is on its way. */
export function useMissions(): MissionEntry[] | null {
  const [missions, setMissions] = useState<MissionEntry[] | null>(null);
  useEffect(() => {
    let alive = true;
    api.missions().then(
      (found) => {
        if (alive) setMissions(found);
      },
      (cause: unknown) => {
        if (!alive) return;
        setMissions([]);
        complain(cause);
      },
    );
    return () => {
      alive = false;
    };
  }, []);
  return missions;
}
