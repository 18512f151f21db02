/**
 * The way to the class of what a pupil changes: it goes a moment after each change. While the class does not answer it waits, in
 * the browser's storage too, so that a later page hands in what an earlier one could not.
 */
import { classApi } from "../../api/class";
import { ApiError } from "../../api/client";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { Mission } from "../../model/types";
import { note, shownName } from "../../session/document";
import { workedOn } from "../../session/open-exercise";
import { setKept, useClassroom } from "./classroom";
import type { Place, StoredMemory, Waiting } from "./hand-in-memory";

const QUIET_MS = 1200;
const LONGEST_MS = 5000;
const AGAIN_MS = 4000;

interface QueueCallbacks {
  /** Everything is with the class. */
  emptied: () => void;
  /** The class does not take anything from this page. */
  forbidden: () => void;
}

export class HandInQueue {
  /** Where the open mission is handed in, and which revision of it the class has. */
  place: Place = { name: "", revision: "" };
  #waiting: (Waiting & { mission: Mission }) | null = null;
  #since = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #sending = false;
  /** The pupil pressed Hand in: it is said when it is done. */
  #pressed = false;
  readonly #memory: StoredMemory;
  readonly #callbacks: QueueCallbacks;

  constructor(memory: StoredMemory, callbacks: QueueCallbacks) {
    this.#memory = memory;
    this.#callbacks = callbacks;
  }

  get isEmpty(): boolean {
    return this.#next() === null;
  }

  /** Whether work on an exercise waits: it is newer than what the class has. */
  hasWorkOn(exercise: string): boolean {
    return this.#next()?.exercise === exercise;
  }

  #next(): Waiting | null {
    return this.#waiting ?? this.#memory.value.waiting;
  }

  /** The open mission has changed. */
  add(): void {
    const { file, mission } = useStudio.getState();
    const now = Date.now();
    if (this.#waiting === null) this.#since = now;
    this.#waiting = { shown: shownName(file.name), place: this.place, mission, exercise: workedOn(file) };
    setKept(useClassroom.getState().connected ? "waits" : "here");
    this.#later(Math.min(QUIET_MS, Math.max(0, this.#since + LONGEST_MS - now)));
  }

  /** Hands in what is open now; `pressed`: and says so. */
  addAtOnce(pressed: boolean): void {
    if (pressed) this.#pressed = true;
    this.add();
    this.#later(0);
  }

  /** The class answers: what waits goes, or else what an earlier page of this browser could not hand in. */
  goOn(): void {
    const next = this.#next();
    if (next === null) return;
    this.#waiting ??= { ...next, mission: next.mission as Mission };
    setKept("waits");
    this.#later(0);
  }

  #later(ms: number): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.send(), ms);
  }

  /** Hands in what waits, without waiting longer. */
  async send(): Promise<void> {
    if (this.#waiting === null || this.#sending) return;
    const mine = this.#waiting;
    this.#sending = true;
    try {
      const { place, shown, mission, exercise } = mine;
      this.#sent(mine, await classApi.handIn(place.name || shown, place.revision, mission, exercise));
    } catch (cause) {
      this.#failed(mine, cause);
    } finally {
      this.#sending = false;
    }
  }

  #sent(mine: Waiting, kept: Place): void {
    const { place, shown } = mine;
    // What was changed meanwhile goes on from what is kept now.
    if (this.place === place) this.place = kept;
    if (this.#waiting === mine) this.#waiting = null;
    else if (this.#waiting?.place === place) this.#waiting.place = kept;
    this.#memory.keep({ places: { ...this.#memory.value.places, [shown]: kept }, waiting: null });
    setKept(this.#waiting === null ? "yes" : "waits", "");
    if (this.#waiting !== null) {
      this.#later(QUIET_MS);
      return;
    }
    this.#callbacks.emptied();
    if (!this.#pressed) return;
    this.#pressed = false;
    const of = useClassroom.getState().news?.class_name ?? "";
    note(t("class.handed-in", { name: kept.name, class: of }), t("class.handed-in-help"));
  }

  #failed(mine: Waiting, cause: unknown): void {
    this.#memory.keep({ waiting: mine });
    const status = cause instanceof ApiError ? cause.status : 0;
    if (status === 403) this.#callbacks.forbidden();
    const refused = status >= 400 && status < 500 && status !== 403 && status !== 429;
    setKept(refused ? "refused" : "here", cause instanceof Error ? cause.message : "");
    if (this.#pressed && !refused) note(t("class.kept-here"), t("class.kept-here-help"));
    this.#later(AGAIN_MS);
  }

  /** Waits no longer; what is here stays. */
  end(): void {
    clearTimeout(this.#timer);
  }
}
