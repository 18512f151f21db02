/** What the teacher's page knows: the class, its pupils as they were told last, whom the teacher looks on. */
import { create } from "zustand";

import { classApi, type ClassSocket, openClassSocket } from "../../../api/class";
import { ApiError } from "../../../api/client";
import type {
  ArenaMessage,
  ClassArena,
  ClassNewsMessage,
  LookMessage,
  Pupil,
  PupilsMessage,
} from "../../../api/generated";
import { whyRefused } from "../../../api/refusal";
import type { Program } from "../../../model/types";
import { useFetched } from "../../../ui/use-fetched";
import { type Filter, type Order, type Seen, sorted } from "./order";

export interface Desk {
  news: ClassNewsMessage | null;
  seen: ReadonlyMap<string, Seen>;
  /** Folders in the order in which cards lie; sorted anew only when that is asked for, or who is there changes. */
  lie: readonly string[];
  filter: Filter;
  order: Order;
  find: string;
  looked: string;
  pictures: ReadonlyMap<string, { version: number; program: Program | null }>;
  /** What the page of the pupil who is looked on shows of its run. */
  arena: ClassArena | null;
  /** Since when nothing came (ms), null while the class answers. */
  lost: number | null;
  /** When work came last (ms), null when none did. */
  kept: number | null;
  refused: boolean;
  said: { words: string; help: string } | null;
}

export const useDesk = create<Desk>(() => ({
  news: null,
  seen: new Map(),
  lie: [],
  filter: "all",
  order: "help",
  find: "",
  looked: "",
  pictures: new Map(),
  arena: null,
  lost: null,
  kept: null,
  refused: false,
  said: null,
}));

export function filterCards(filter: Filter): void {
  useDesk.setState({ filter });
}

export function findPupils(find: string): void {
  useDesk.setState({ find });
}

export function dismissNotice(): void {
  useDesk.setState({ said: null });
}

const set = useDesk.setState;
let socket: ClassSocket<LookMessage> | null = null;

export function fail(cause: unknown): void {
  const { message, help } = whyRefused(cause);
  say(message, help);
}

export function say(words: string, help = ""): void {
  set({ said: { words, help } });
}

/** What comes of a request, null until then; a failure is said. */
export function useFound<T>(get: () => Promise<T>): T | null {
  return useFetched(get, (cause) => {
    fail(cause);
    return null;
  });
}

/** Does it, and says why when it could not be done. */
export function act(work: Promise<unknown>): void {
  set({ said: null });
  work.catch(fail);
}

/** Freezes those pupils, null for all, or lets them go on; shown at once, so that a second press is the other one. */
export function freeze(on: boolean, folders: readonly string[] | null): void {
  act(
    classApi.freeze(on, folders).then(() =>
      set(({ news, seen }) => ({
        news: news === null ? null : { ...news, frozen: folders === null ? on : news.frozen && on },
        seen: new Map(
          [...seen].map(([folder, one]) => [
            folder,
            folders?.includes(folder) === false ? one : { ...one, pupil: { ...one.pupil, frozen: on } },
          ]),
        ),
      })),
    ),
  );
}

export function pupilsOf({ seen }: Pick<Desk, "seen">): Pupil[] {
  return [...seen.values()].map(({ pupil }) => pupil);
}

export function sortBy(order: Order): void {
  set((desk) => ({ order, lie: sorted(pupilsOf(desk), order) }));
}

export function look(folder: string): void {
  set({ looked: folder, arena: null });
  socket?.say({ type: "look", folder });
}

function hearPupils({ changed, gone, kept_s }: PupilsMessage): void {
  const desk = useDesk.getState();
  const now = Date.now();
  set({ kept: kept_s === null ? null : now - kept_s * 1000, lost: null });
  if (changed.length === 0 && gone.length === 0) return;
  const seen = new Map(desk.seen);
  let others = false;
  for (const pupil of changed) {
    others ||= !seen.has(pupil.folder);
    seen.set(pupil.folder, { pupil, at: now });
  }
  for (const folder of gone) others = seen.delete(folder) || others;
  // Cards never move under the pointer: only who comes or goes changes how they lie.
  const lie = others ? sorted(pupilsOf({ seen }), desk.order) : desk.lie;
  const looked = seen.has(desk.looked) ? desk.looked : "";
  set({ seen, lie, looked });
  if (looked !== desk.looked) look("");
  for (const pupil of changed) void fetchPicture(pupil);
}

const fetching = new Set<string>();

/** The picture of what was handed in last; one at a time for each pupil. */
async function fetchPicture({ folder, version }: Pupil): Promise<void> {
  const known = useDesk.getState().pictures.get(folder);
  if (version === 0 || known?.version === version || fetching.has(folder)) return;
  fetching.add(folder);
  try {
    const found = await classApi.picture(folder);
    const program = found?.program ?? null;
    set(({ pictures }) => ({ pictures: new Map(pictures).set(folder, { version, program }) }));
  } catch {
    // The next change asks again.
  } finally {
    fetching.delete(folder);
  }
  const now = useDesk.getState().seen.get(folder)?.pupil;
  if (now !== undefined && now.version !== version) void fetchPicture(now);
}

/** Begins; the returned function ends it. */
export function keepDesk(): () => void {
  socket = openClassSocket<LookMessage, ClassNewsMessage | PupilsMessage | ArenaMessage>("teacher/watch", {
    onOpen: () => {
      set({ lost: null, refused: false });
      const { looked } = useDesk.getState();
      if (looked !== "") socket?.say({ type: "look", folder: looked });
    },
    onMessage: (message) => {
      if (message.type === "class") set({ news: message });
      else if (message.type === "pupils") hearPupils(message);
      else if (message.arena !== null && message.folder === useDesk.getState().looked) set({ arena: message.arena });
    },
    onSilence: (silent) => set(({ lost }) => ({ lost: silent ? (lost ?? Date.now()) : null })),
    onLost: () => {
      set(({ lost }) => ({ lost: lost ?? Date.now() }));
      classApi.log().catch((cause: unknown) => {
        if (cause instanceof ApiError && cause.status === 403) set({ refused: true });
      });
    },
  });
  return () => {
    socket?.close();
    socket = null;
  };
}
