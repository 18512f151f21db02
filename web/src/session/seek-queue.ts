/** Places on the timeline that are asked for: one at a time, and of those that wait only the newest. */
export class SeekQueue {
  /** What was asked for and is not answered yet. */
  #asked: number | null = null;
  #next: number | null = null;
  readonly #send: (tick: number) => void;

  constructor(send: (tick: number) => void) {
    this.#send = send;
  }

  /** The tick that the run is on its way to; null when it is where it was last asked to be. */
  get target(): number | null {
    return this.#next ?? this.#asked;
  }

  ask(tick: number): void {
    if (this.#asked === null) {
      this.#asked = tick;
      this.#send(tick);
    } else this.#next = tick;
  }

  /** The run has come to the tick that was asked for. */
  answer(): void {
    const next = this.#next;
    this.clear();
    if (next !== null) this.ask(next);
  }

  clear(): void {
    this.#asked = null;
    this.#next = null;
  }
}
