/** Named values, each with its picture: patches of colours, pictures of lights with the chosen one large, or words. */
import { type KeyboardEvent, useEffect, useRef } from "react";

import { mirrored } from "../../i18n/language";
import { lightsPath } from "../../model/meaning";
import { text } from "../../model/texts";
import { Icon } from "../../theme";
import { ChoicePicture } from "../ChoicePicture";
import type { ControlProps } from "./FieldRow";

const SMALL = 22;

/** Where a key leads among `count` choices, or null. */
export function choiceBy(key: string, at: number, count: number, isMirrored: boolean): number | null {
  const forward = key === "ArrowDown" || key === (isMirrored ? "ArrowLeft" : "ArrowRight");
  const back = key === "ArrowUp" || key === (isMirrored ? "ArrowRight" : "ArrowLeft");
  if (forward) return (at + 1) % count;
  if (back) return (at - 1 + count) % count;
  return key === "Home" ? 0 : key === "End" ? count - 1 : null;
}

interface ChoicesProps extends ControlProps {
  testid: string;
  /** Whether they take the focus when they appear. */
  focused: boolean;
}

export function Choices({ field, value, label, set, leave, onFocus, testid, focused }: ChoicesProps) {
  const group = useRef<HTMLSpanElement>(null);
  const choices = field.meaning?.choices ?? [];
  const chosen = choices.find((one) => one.value === value);
  const look = choices.every((one) => one.lights) ? "lights" : choices.every((one) => one.colour) ? "colour" : "words";
  const tab = chosen ?? choices[0];
  useEffect(() => {
    if (focused) group.current?.querySelector<HTMLElement>("[tabindex='0']")?.focus({ preventScroll: true });
  }, [focused]);
  const onKeyDown = (event: KeyboardEvent) => {
    if (leave(event)) return;
    const at = choices.findIndex((one) => one === tab);
    const next = choices[choiceBy(event.key, at, choices.length, mirrored()) ?? -1];
    if (next === undefined) return;
    event.preventDefault();
    set(next.value);
    group.current?.querySelector<HTMLElement>(`[data-value="${String(next.value)}"]`)?.focus();
  };
  return (
    <span className="field-choices flex gap-xl items-start" data-look={look}>
      <span
        ref={group}
        className="choices wrap flex gap-s grow"
        role="radiogroup"
        aria-label={label}
        data-testid={testid}
        onKeyDown={onKeyDown}
        onFocus={onFocus}
      >
        {choices.map((one) => {
          const name = text(one.label);
          return (
            <button
              key={one.value}
              type="button"
              role="radio"
              className="choice"
              aria-checked={one === chosen}
              aria-label={name}
              title={look === "lights" ? name : undefined}
              tabIndex={one === tab ? 0 : -1}
              data-value={one.value}
              {...(one === tab ? { "data-inspector-field": "" } : {})}
              onClick={() => set(one.value)}
            >
              {look === "colour" ? (
                <span className="choice-patch centred" style={{ background: one.colour }}>
                  {one === chosen ? <Icon name="check" size={16} /> : null}
                </span>
              ) : one.icon || one.lights ? (
                <ChoicePicture choice={one} size={SMALL} />
              ) : null}
              {look === "lights" ? null : <span>{name}</span>}
            </button>
          );
        })}
      </span>
      {look === "lights" && chosen !== undefined ? (
        <span className="choices-large row small-text rigid text-centre" aria-hidden="true">
          <svg width="78" height="78" viewBox="-.6 -.6 6 6">
            <path className="lights-off" d={lightsPath("1".repeat(25))} />
            <path className="lights-on" d={lightsPath(chosen.lights ?? "")} />
          </svg>
          {text(chosen.label)}
        </span>
      ) : null}
    </span>
  );
}
