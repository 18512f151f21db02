/**
 * One tab of the browser at a time has the studio of a static site: two would each have a copy of the same files, and write over
 * each other's.
 *
 * Browsers give locks only to pages of safe addresses, not to those that come over `http://` from another machine. There a
 * database that is empty is the lock: it is made anew, in a version of its own, only when nobody else has it open, and who has
 * made it keeps it open.
 */

export interface Turn {
  /** Called once no other tab has it; it is kept as long as the page is there. */
  begin: () => void;
  /** Called when another tab has it; `begin` comes when that is closed. */
  wait: () => void;
}

export function alone(name: string, turn: Turn): void {
  // A browser that gives neither keeps nothing of this page, and nothing can be written over.
  const locked = "locks" in navigator ? byLock(name, turn) : byDatabase(name, turn);
  locked.catch(turn.begin);
}

async function byLock(name: string, { begin, wait }: Turn): Promise<void> {
  const hold = () => {
    begin();
    return new Promise<never>(() => undefined);
  };
  await navigator.locks.request(name, { ifAvailable: true }, (lock) => {
    if (lock !== null) return hold();
    wait();
    return undefined;
  });
  await navigator.locks.request(name, hold);
}

/** Open connections, so that they are not collected. */
const held: IDBDatabase[] = [];

async function byDatabase(name: string, { begin, wait }: Turn): Promise<void> {
  for (let version: number | undefined; ;) {
    const { database, made } = await opened(name, version, wait);
    if (made && version !== undefined) {
      held.push(database);
      begin();
      return;
    }
    // Another tab made this version, or it is from another time.
    version = database.version + 1;
    database.close();
  }
}

interface Opened {
  database: IDBDatabase;
  /** Whether this version was made now: nobody else has it open. */
  made: boolean;
}

function opened(name: string, version: number | undefined, blocked: () => void): Promise<Opened> {
  return new Promise((resolve, reject) => {
    const asked = indexedDB.open(name, version);
    let made = false;
    asked.onupgradeneeded = () => {
      made = true;
    };
    asked.onblocked = blocked;
    asked.onsuccess = () => resolve({ database: asked.result, made });
    // A lower version than another tab has made meanwhile is asked for again.
    asked.onerror = () => {
      if (asked.error?.name === "VersionError" && version !== undefined) resolve(opened(name, undefined, blocked));
      else reject(asked.error ?? new Error(name));
    };
  });
}
