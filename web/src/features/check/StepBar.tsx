/** Goes through moments one at a time: back, on, by itself, and to the one that decided; by keys too. */
import { type KeyboardEvent, type ReactNode, useEffect, useState } from "react";

import { mirrored } from "../../i18n/language";
import { t } from "../../i18n/words";
import { Tool } from "../../ui/Tool";

/** How long a moment is shown while it plays. */
const STEP_MS = 700;

export interface Steps {
  at: number;
  last: number;
  plays: boolean;
  go: (to: number) => void;
  toggle: () => void;
}

/** Moments 0 to `last`; `after` gives the one that plays after another, null at the end. */
export function useSteps(last: number, after: (at: number) => number | null): Steps {
  const [at, setAt] = useState(0);
  const [plays, setPlays] = useState(false);
  const following = after(at);
  useEffect(() => {
    if (!plays) return;
    const timer = setTimeout(() => (following === null ? setPlays(false) : setAt(following)), STEP_MS);
    return () => clearTimeout(timer);
  }, [plays, following]);
  return {
    at,
    last,
    plays,
    go: (to) => {
      setPlays(false);
      setAt(Math.min(Math.max(to, 0), last));
    },
    toggle: () => {
      if (!plays && at === last) setAt(0);
      setPlays(!plays);
    },
  };
}

interface Props {
  steps: Steps;
  label: string;
  /** The moment that decided; -1 for none. */
  decided?: number;
  children: ReactNode;
}

export function StepBar({ steps: { at, last, plays, go, toggle }, label, decided = -1, children }: Props) {
  const pressed = (event: KeyboardEvent) => {
    const forward = mirrored() ? "ArrowLeft" : "ArrowRight";
    if (event.key === forward) go(at + 1);
    else if (event.key === (mirrored() ? "ArrowRight" : "ArrowLeft")) go(at - 1);
    else if (event.key === "Home") go(0);
    else if (event.key === "End") go(last);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div className="check-steps-row row small-text gap-xs" role="group" aria-label={label} onKeyDown={pressed}>
      <Tool small icon="step-back" label={t("check.step-back")} disabled={at === 0} onClick={() => go(at - 1)} />
      <Tool
        small
        icon={plays ? "pause" : "play"}
        label={plays ? t("run.pause") : t("check.step-play")}
        testId="check-steps-play"
        onClick={toggle}
      />
      <Tool
        small
        icon="step-forward"
        label={t("check.step-on")}
        testId="check-step-on"
        disabled={at === last}
        onClick={() => go(at + 1)}
      />
      {decided < 0 ? null : (
        <Tool small icon="git-fork" label={t("check.to-moment")} testId="check-to-moment" onClick={() => go(decided)} />
      )}
      <span className="check-count figures" role="status">
        {children}
      </span>
    </div>
  );
}
