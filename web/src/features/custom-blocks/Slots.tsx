/** The slots of a part: the words for each, and the range of what is a number. */
import { languageInUse, type Key, t } from "../../i18n/words";
import { text } from "../../model/texts";
import type { Slot } from "../../model/types";
import { defaultOf, whole } from "./openings";
import { NumberRange, type Range } from "./NumberRange";

interface SlotsProps {
  slots: Slot[];
  onChange: (slots: Slot[]) => void;
}

function ranged(slot: Slot, to: Partial<Range>): Slot {
  return {
    ...slot,
    ...(to.min === undefined ? {} : { min: whole(to.min) }),
    ...(to.max === undefined ? {} : { max: whole(to.max) }),
    ...(to.first === undefined ? {} : { default: defaultOf(slot.kind, to.first) }),
    ...(to.unit === undefined ? {} : { unit: to.unit }),
  };
}

function labelled(slot: Slot, words: string): Slot {
  const language = languageInUse();
  const key = language in slot.label ? language : "";
  const { [key]: _, ...rest } = slot.label;
  return { ...slot, label: words.trim() === "" || words === slot.name ? rest : { ...rest, [key]: words } };
}

export function Slots({ slots, onChange }: SlotsProps) {
  const change = (name: string, to: (slot: Slot) => Slot) => {
    onChange(slots.map((one) => (one.name === name ? to(one) : one)));
  };
  return (
    <fieldset className="own-openings">
      <legend>{t("own.slots")}</legend>
      {slots.length === 0 ? <p className="sheet-note muted small-text">{t("own.slots-none")}</p> : null}
      <ul>
        {slots.map((slot) => {
          const range = {
            min: slot.min === null ? "" : String(slot.min),
            max: slot.max === null ? "" : String(slot.max),
            first: slot.default,
            unit: slot.unit,
          };
          return (
            <li key={slot.name} data-testid={`slot-${slot.name}`}>
              <div className="row">
                <code dir="ltr">{`{${slot.name}}`}</code>
                <span className="muted small-text to-end">{t(`own.kind-${slot.kind}` as Key)}</span>
              </div>
              <div className="own-opening wrap flex gap-m">
                <label className="own-named">
                  <span>{t("own.name")}</span>
                  <input
                    className="field"
                    value={text(slot.label, slot.name)}
                    autoComplete="off"
                    maxLength={40}
                    aria-label={t("own.open-name", { what: slot.name })}
                    onChange={(event) => change(slot.name, (one) => labelled(one, event.target.value))}
                  />
                </label>
                {slot.kind === "number" || slot.kind === "value" ? (
                  <NumberRange
                    of={range}
                    means={slot.meaning}
                    what={text(slot.label, slot.name)}
                    onChange={(to) => change(slot.name, (one) => ranged(one, to))}
                  />
                ) : null}
              </div>
            </li>
          );
        })}
      </ul>
    </fieldset>
  );
}
