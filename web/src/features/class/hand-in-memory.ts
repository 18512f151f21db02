/** What a pupil's page remembers of what it handed in: under which name and revision the class keeps each mission. */
import { pupilName } from "../../api/token";
import { parseStored, readStored, writeStored } from "../../ui/browser-storage";

export interface Place {
  name: string;
  revision: string;
}

/** What waits to be handed in: the mission as it was, in case the page is closed before. */
export interface Waiting {
  shown: string;
  place: Place;
  mission: unknown;
  /** The exercise that it is for, "" for none. */
  exercise: string;
}

export interface Memory {
  /** By the name that the page shows. */
  places: Record<string, Place>;
  waiting: Waiting | null;
  /** Whether the first mission of this pupil was opened in this browser. */
  begun: boolean;
  /** What was offered already. */
  handed: number;
  exercise: string;
  note: number;
  /** By the exercise. */
  comments: Record<string, string>;
}

export const NOTHING: Memory = {
  places: {},
  waiting: null,
  begun: false,
  handed: 0,
  exercise: "",
  note: 0,
  comments: {},
};

function isPlace(value: unknown): value is Place {
  if (typeof value !== "object" || value === null) return false;
  const { name, revision } = value as Record<string, unknown>;
  return typeof name === "string" && typeof revision === "string";
}

/** What was remembered, as far as it makes sense. */
export function readMemory(text: string | null): Memory {
  const found = parseStored(text);
  const { places, waiting, begun, handed, exercise, note, comments } = (
    typeof found === "object" && found !== null ? found : {}
  ) as Record<string, unknown>;
  const known =
    typeof places === "object" && places !== null ? Object.entries(places).filter(([, one]) => isPlace(one)) : [];
  const {
    shown,
    place,
    mission,
    exercise: of,
  } = (typeof waiting === "object" && waiting !== null ? waiting : {}) as Record<string, unknown>;
  const whole = typeof shown === "string" && isPlace(place) && typeof mission === "object" && mission !== null;
  return {
    places: Object.fromEntries(known),
    waiting: whole ? { shown, place, mission, exercise: typeof of === "string" ? of : "" } : null,
    begun: begun === true,
    handed: typeof handed === "number" ? handed : 0,
    exercise: typeof exercise === "string" ? exercise : "",
    note: typeof note === "number" ? note : 0,
    comments: Object.fromEntries(
      Object.entries(typeof comments === "object" && comments !== null ? comments : {}).filter(
        (one): one is [string, string] => typeof one[1] === "string",
      ),
    ),
  };
}

/**
 * Where a mission that is opened is handed in: a fresh one (an example, what was handed out, a new one) beside whatever has
 * its name, another one where it was before.
 */
export function placeFor(memory: Memory, shown: string, fresh: boolean): Place {
  const known = memory.places[shown];
  return fresh || known === undefined ? { name: shown, revision: "" } : known;
}

/** Where it is stored in this browser: of another pupil at this computer nothing is used. */
export const storageName = () => `kitrobot.class.kept.${pupilName()}`;

/** What is remembered of this pupil, in the page and in the browser's storage. */
export class StoredMemory {
  value: Memory = readMemory(null);

  /** Reads what an earlier page stored. */
  recall(): void {
    this.value = readMemory(readStored(storageName()));
  }

  keep(change: Partial<Memory>): void {
    this.value = { ...this.value, ...change };
    // Where storage is full or denied, the work is in the page, and with the class once it answers.
    writeStored(storageName(), JSON.stringify(this.value));
  }
}
