/** Goes through moments: back, on, by itself, to any of them, and to the one that decided; by keys too. */
import { type CSSProperties, type KeyboardEvent, type ReactNode, type RefObject, useEffect, useState } from "react";

import { keepDrawing, wantsLessMotion } from "../../components/picture-clock";
import { mirrored } from "../../i18n/language";
import { t } from "../../i18n/words";
import { Select } from "../../ui/Select";
import { Tool } from "../../ui/Tool";

/** Steps of the model a second. */
export const STEPS_A_SECOND = 1 / 0.7;
const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16];
/** Nobody waits longer than that for an end, in seconds. */
const LONGEST_S = 30;
/** A step begins so much before it: sums of fractions fall a little short of it. */
const NEAR = 1e-6;

interface Length {
  /** The last moment; the first is 0. */
  length: number;
  /** How far apart the moments are that one steps through. */
  unit: number;
  /** How far a second goes. */
  rate: number;
  /** Where what repeats begins again; null: it ends. */
  again?: number | null;
}

export interface Steps extends Length {
  at: number;
  plays: boolean;
  speed: number;
  setSpeed: (speed: number) => void;
  go: (to: number) => void;
  step: (by: 1 | -1) => void;
  toggle: () => void;
}

/** The first speed at which nobody waits too long for the end. */
function usualSpeed({ length, rate }: Length): number {
  return SPEEDS.find((speed) => speed >= 1 && length / rate / speed <= LONGEST_S) ?? 16;
}

export function useSteps({ length, unit, rate, again = null }: Length): Steps {
  const [place, setPlace] = useState(0);
  const [chosen, setSpeed] = useState<number | null>(null);
  const [wanted, setPlays] = useState(false);
  const speed = chosen ?? usualSpeed({ length, unit, rate });
  const plays = wanted && (again !== null || place < length);
  useEffect(() => {
    if (!plays) return;
    // What repeats shows its last moment as long as any other.
    const end = again === null ? length : length + unit;
    let before = performance.now();
    return keepDrawing((now) => {
      const on = (Math.max(0, now - before) / 1000) * rate * speed;
      before = now;
      setPlace((from) => (from + on < end ? from + on : again === null ? end : again + (from + on - end)));
    });
  }, [plays, length, unit, rate, speed, again]);
  const go = (to: number) => {
    setPlays(false);
    setPlace(Math.min(Math.max(to, 0), length));
  };
  // Who wants less motion sees moments that are a second apart, or a step.
  const grain = plays && wantsLessMotion() ? Math.max(unit, 1) : 0;
  return {
    ...{ length, unit, rate, again, plays, speed, setSpeed, go },
    at: grain === 0 || place >= length ? place : Math.floor(place / grain + NEAR) * grain,
    step: (by) => go((by > 0 ? Math.floor(place / unit + NEAR) + 1 : Math.ceil(place / unit - NEAR) - 1) * unit),
    toggle: () => {
      if (!plays && place >= length) setPlace(0);
      setPlays(!plays);
    },
  };
}

/** What a key does to the moments. */
export function stepByKey(event: KeyboardEvent, { go, step, toggle, length }: Steps): void {
  const [back, on] = mirrored() ? ["ArrowRight", "ArrowLeft"] : ["ArrowLeft", "ArrowRight"];
  const at = event.target instanceof HTMLElement ? event.target.tagName : "";
  if (at === "SELECT" || event.altKey || event.ctrlKey || event.metaKey) return;
  if (event.key === on) step(1);
  else if (event.key === back) step(-1);
  else if (event.key === "Home") go(0);
  else if (event.key === "End") go(length);
  else if (event.key === " " && at !== "BUTTON") toggle();
  else return;
  event.preventDefault();
  event.stopPropagation();
}

interface Props {
  steps: Steps;
  label: string;
  /** The moment that decided; -1 for none. */
  decided?: number;
  /** Moments that are marked on the line on which any moment is chosen; no line without. */
  marks?: readonly number[];
  /** The moment in words, for the line. */
  words?: string;
  /** The button that plays. */
  play?: RefObject<HTMLButtonElement | null>;
  children: ReactNode;
}

export function StepBar({ steps, label, decided = -1, marks, words, play, children }: Props) {
  const { at, length, unit, plays, speed, go, step, toggle } = steps;
  return (
    <div
      className="check-steps-row row small-text gap-xs"
      role="group"
      aria-label={label}
      onKeyDown={(event) => stepByKey(event, steps)}
    >
      <Tool small icon="step-back" label={t("check.step-back")} disabled={at <= 0} onClick={() => step(-1)} />
      <Tool
        small
        icon={plays ? "pause" : "play"}
        label={plays ? t("run.pause") : t("check.step-play")}
        testId="check-steps-play"
        ref={play}
        onClick={toggle}
      />
      <Tool
        small
        icon="step-forward"
        label={t("check.step-on")}
        testId="check-step-on"
        disabled={at >= length}
        onClick={() => step(1)}
      />
      {decided < 0 ? null : (
        <Tool small icon="git-fork" label={t("check.to-moment")} testId="check-to-moment" onClick={() => go(decided)} />
      )}
      {marks === undefined ? null : (
        <span className="check-line grow relative aligned">
          <input
            className="slider wide"
            type="range"
            min={0}
            max={length}
            step={unit / 4}
            value={at}
            style={{ "--share": length > 0 ? at / length : 0 } as CSSProperties}
            aria-label={label}
            aria-valuetext={words}
            data-testid="check-line"
            onChange={(event) => go(event.target.valueAsNumber)}
          />
          {marks.map((mark) => (
            <span
              key={mark}
              className="check-line-mark passive"
              style={{ "--share": mark / length } as CSSProperties}
              aria-hidden="true"
            />
          ))}
        </span>
      )}
      <span className="check-count figures" role="status" aria-live={plays ? "off" : "polite"}>
        {children}
      </span>
      {marks === undefined ? null : (
        <Select
          className="field check-speed"
          label={t("run.speed")}
          testId="check-speed"
          value={String(speed)}
          options={SPEEDS.map((one) => [String(one), t("run.times", { factor: one })])}
          keep={(value) => steps.setSpeed(SPEEDS.find((one) => String(one) === value) ?? 1)}
        />
      )}
    </div>
  );
}
