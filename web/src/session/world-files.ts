/**
 * Keeps what the page holds of the files around the mission as they are on disk: robots, constructors, the world.
 *
 * The watch tells the state of the files by a name; when it is another one than that of what the page holds, all of it is
 * fetched anew, and of answers only the newest counts. The world also follows the mission, through undo and redo; worlds
 * that were seen once are there at once. While the server cannot be reached, what the page holds stays.
 */
import { create } from "zustand";

import { partsApi } from "../api/parts";
import type { News } from "../api/watch";
import { prepareLanguage } from "../i18n/language";
import type { Language } from "../i18n/words";
import { OWN_WORLD, sameWorld } from "../model/commands/changeWorld";
import { useStudio } from "../model/studio";
import type { World } from "../model/types";
import type { drawnWorld } from "../model/world/drawing";

/** Counts how often the files were read, for components that show more of them than the document has. */
export const useFiles = create<{ read: number }>(() => ({ read: 0 }));

/** The state of the files that the page holds; "" when it is unknown, null until the first mission is there. */
let held: string | null = null;
let asked = 0;
/** Draws a mission's own world; fetched for the first mission that has one. */
let draw: typeof drawnWorld | null = null;
const worlds = new Map<string, World | null>();

const keyOf = (path: string, href: string) => `${path}\n${href}`;

/** A mission was opened with the files in this state. */
export function holdParts(stamp: string): void {
  held = stamp;
  asked++;
  const { file, worldOf, world } = useStudio.getState();
  worlds.clear();
  worlds.set(keyOf(file.path, worldOf), world);
  followWorld();
}

// Parts come with the words of one language.
prepareLanguage((language) => (held === null ? Promise.resolve(() => undefined) : fetchParts(language)));

export function hearOfParts({ path, parts }: News): void {
  if (parts === "" || held === null || parts === held || path !== useStudio.getState().file.path) return;
  void readParts();
}

/** Reads the files anew. Resolves when they are there, or cannot be had. */
export async function readParts(): Promise<void> {
  (await fetchParts())();
}

/** Fetches the files anew; what it gives puts them in place, unless others were asked for meanwhile. */
async function fetchParts(language?: Language): Promise<() => void> {
  const mine = ++asked;
  const { file, mission } = useStudio.getState();
  try {
    const [{ stamp, catalogue }, { world }] = await Promise.all([
      partsApi.catalogue(file.path, language),
      partsApi.world(file.path, mission.world),
    ]);
    return () => {
      if (mine !== asked || useStudio.getState().file.path !== file.path) return;
      held = stamp;
      worlds.clear();
      worlds.set(keyOf(file.path, mission.world), world);
      useStudio.getState().loadParts(catalogue);
      useStudio.getState().loadWorld(mission.world, world);
      useFiles.setState(({ read }) => ({ read: read + 1 }));
      followWorld();
    };
  } catch {
    // The next connection brings news, and then everything.
    if (mine === asked) held = "";
    return () => undefined;
  }
}

/** Brings the world that the mission takes place in. */
function followWorld(): void {
  const { file, mission, world, worldOf, loadWorld } = useStudio.getState();
  if (mission.own_world != null) {
    if (draw === null) {
      void import("../model/world/drawing").then((chunk) => {
        draw = chunk.drawnWorld;
        followWorld();
      });
      return;
    }
    const own = draw(mission.own_world);
    if (own !== world) loadWorld(OWN_WORLD, own);
    return;
  }
  const href = mission.world;
  if (sameWorld(href, worldOf)) return;
  const known = worlds.get(keyOf(file.path, href));
  if (known !== undefined) {
    loadWorld(href, known);
    return;
  }
  partsApi.world(file.path, href).then(
    ({ world }) => {
      worlds.set(keyOf(file.path, href), world);
      const now = useStudio.getState();
      if (now.file.path !== file.path || now.mission.own_world != null) return;
      if (now.mission.world === href) loadWorld(href, world);
    },
    () => undefined,
  );
}

/** A world that the page has seen elsewhere, so that choosing it shows it at once. */
export function primeWorld(href: string, world: World | null): void {
  worlds.set(keyOf(useStudio.getState().file.path, href), world);
}

/** Lets the world follow the mission; the returned function ends that. */
export function keepWorld(): () => void {
  return useStudio.subscribe((state, before) => {
    const [now, then] = [state.mission, before.mission];
    const other = now.world !== then.world || now.own_world !== then.own_world;
    if (other && state.change.kind !== "open") followWorld();
  });
}
