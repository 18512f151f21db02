/** A small piano for a number of Hz: ten white keys from a C, and another octave by its buttons. A note sounds as it is chosen. */
import { type KeyboardEvent, useRef, useState } from "react";

import { mirrored } from "../../i18n/language";
import { t } from "../../i18n/words";
import { noteOf } from "../../model/meaning";
import { Icon } from "../../theme";
import type { ControlProps } from "./FieldRow";
import { sound } from "./sound";
import { within } from "./number-text";

/** Semitones above the first C; the black ones stand behind the white one before them. */
const KEYS = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16];
const BLACK = new Set([1, 3, 6, 8, 10]);
const [LOWEST, HIGHEST] = [2, 7];

/** Hz of the key so many semitones above the C of an octave, as a whole number. */
export function hzOf(octave: number, semitone: number): number {
  return Math.round(440 * 2 ** ((12 * (octave - 4) + semitone - 9) / 12));
}

/** The octave of a number of Hz; the middle one for a rest. */
export function octaveOf(hz: number): number {
  return hz < 16 ? 4 : 4 + Math.floor((Math.round(12 * Math.log2(hz / 440)) + 9) / 12);
}

function isBlack(key: number): boolean {
  return BLACK.has(key % 12);
}

export function Piano({ field, value, label, set, leave, onFocus }: ControlProps) {
  const keys = useRef<HTMLSpanElement>(null);
  const [octave, setOctave] = useState(() => Math.min(HIGHEST, Math.max(LOWEST, octaveOf(value))));
  const chosen = KEYS.find((key) => hzOf(octave, key) === value);
  const play = (key: number) => {
    const hz = within(hzOf(octave, key), field);
    set(hz);
    sound(hz);
  };
  const shift = (by: number) => {
    setOctave(octave + by);
    if (chosen !== undefined) {
      const hz = within(hzOf(octave + by, chosen), field);
      set(hz);
      sound(hz);
    }
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (leave(event)) return;
    const [on, back] = mirrored() ? ["ArrowLeft", "ArrowRight"] : ["ArrowRight", "ArrowLeft"];
    const by =
      event.key === on || event.key === "ArrowUp" ? 1 : event.key === back || event.key === "ArrowDown" ? -1 : 0;
    const last = KEYS.length - 1;
    const to = event.key === "Home" ? 0 : event.key === "End" ? last : by === 0 ? null : (chosen ?? 0) + by;
    if (to === null) return;
    event.preventDefault();
    const next = Math.min(last, Math.max(0, to));
    play(next);
    keys.current?.querySelector<HTMLElement>(`[data-key="${String(next)}"]`)?.focus();
  };
  const middle = octave === 4 ? t("fields.middle-octave") : t("fields.octave", { number: octave });
  return (
    <span className="field-piano column gap-m">
      <span
        ref={keys}
        className="piano relative"
        role="radiogroup"
        aria-label={label}
        onKeyDown={onKeyDown}
        onFocus={onFocus}
      >
        {KEYS.map((key) => (
          <button
            key={key}
            type="button"
            role="radio"
            aria-checked={key === chosen}
            aria-label={noteOf(hzOf(octave, key))}
            tabIndex={key === (chosen ?? 0) ? 0 : -1}
            data-key={key}
            data-black={isBlack(key)}
            style={{ "--at": KEYS.filter((one) => one < key && !isBlack(one)).length } as React.CSSProperties}
            onClick={() => play(key)}
          >
            {isBlack(key) ? null : <span>{noteOf(hzOf(octave, key)).split(" ")[0]}</span>}
          </button>
        ))}
      </span>
      <span className="piano-row row gap-s">
        <button
          type="button"
          aria-label={t("fields.lower")}
          title={t("fields.lower")}
          disabled={octave <= LOWEST}
          onClick={() => shift(-1)}
        >
          <Icon name="chevron-left" size={16} />
        </button>
        <span className="piano-octave text-centre">{middle}</span>
        <button
          type="button"
          aria-label={t("fields.higher")}
          title={t("fields.higher")}
          disabled={octave >= HIGHEST}
          onClick={() => shift(1)}
        >
          <Icon name="chevron-right" size={16} />
        </button>
        <button type="button" className="piano-listen" onClick={() => sound(value)}>
          <Icon name="volume-2" size={16} /> {t("fields.listen")}
        </button>
      </span>
    </span>
  );
}
