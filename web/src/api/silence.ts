/**
 * Whether the server at the other end of a socket still answers: a connection that is open says nothing about that.
 *
 * It is asked at each beat. Two beats without a word from it are silence; beats are counted, not measured, so a computer that
 * slept hears no silence when it wakes.
 */
const BEAT_MS = 4000;
const MOST_UNANSWERED = 2;

export interface Silence {
  /** Something came. */
  heard: () => void;
  end: () => void;
}

/** Begins to ask; `tell` hears when silence begins, and when it is over. */
export function watchSilence(ask: () => void, tell: (silent: boolean) => void): Silence {
  let unanswered = 0;
  let silent = false;
  const say = (now: boolean) => {
    if (now !== silent) tell((silent = now));
  };
  const timer = setInterval(() => {
    say(unanswered >= MOST_UNANSWERED);
    unanswered++;
    ask();
  }, BEAT_MS);
  return {
    heard: () => {
      unanswered = 0;
      say(false);
    },
    end: () => clearInterval(timer),
  };
}
