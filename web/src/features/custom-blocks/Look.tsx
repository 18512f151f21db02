/** How a part is called and drawn: name, what it does, icon, colour. */
import { useId, useState } from "react";

import { type Key, t } from "../../i18n/words";
import type { Colour } from "../../model/types";
import { Icon, Tile } from "../../theme";
import ICONS from "../../theme/icons.lucide";
import { Field } from "../../ui/Field";

export interface LookOf {
  name: string;
  help: string;
  icon: string;
  colour: Colour;
}

const COLOURS: readonly Colour[] = ["loop", "choice", "parallel", "action", "test", "team"];
/** Signs of the page itself, which say nothing about what a part does. */
const OF_THE_PAGE = /^(chevron|panel|circle-alert|octagon|triangle-alert|x$|check$|zoom|undo|redo|more|ellipsis)/;
const CHOICES = Object.keys(ICONS).filter((name) => !OF_THE_PAGE.test(name));

interface LookProps {
  look: LookOf;
  wrong: string;
  onChange: (look: LookOf) => void;
}

export function Look({ look, wrong, onChange }: LookProps) {
  const id = useId();
  // The one that it had comes first, where it is seen.
  const [first] = useState(look.icon);
  const icons = first === "" ? CHOICES : [first, ...CHOICES.filter((name) => name !== first)];
  return (
    <>
      <Field label={t("own.name")}>
        <input
          className="field"
          data-testid="own-name"
          dir="auto"
          value={look.name}
          autoFocus
          spellCheck={false}
          autoComplete="off"
          maxLength={80}
          aria-invalid={wrong !== ""}
          aria-describedby={`${id}-wrong`}
          onFocus={(event) => event.target.select()}
          onChange={(event) => onChange({ ...look, name: event.target.value })}
        />
      </Field>
      <p className="own-wrong small-text" id={`${id}-wrong`} role="status">
        {wrong}
      </p>
      <Field label={t("own.help")}>
        <input
          className="field"
          data-testid="own-help-text"
          dir="auto"
          value={look.help}
          autoComplete="off"
          maxLength={300}
          onChange={(event) => onChange({ ...look, help: event.target.value })}
        />
      </Field>
      <fieldset className="own-colours flex gap-xs">
        <legend className="field-title muted small-text rigid">{t("own.colour")}</legend>
        {COLOURS.map((colour) => (
          <label key={colour} title={t(`own.colour-${colour}` as Key)}>
            <input
              type="radio"
              name={`${id}-colour`}
              checked={look.colour === colour}
              aria-label={t(`own.colour-${colour}` as Key)}
              data-testid={`own-colour-${colour}`}
              onChange={() => onChange({ ...look, colour })}
            />
            <Tile icon={look.icon} colour={colour} size={28} />
          </label>
        ))}
      </fieldset>
      <fieldset className="own-icons">
        <legend className="field-title muted small-text rigid">{t("own.icon")}</legend>
        <div>
          {icons.map((icon) => (
            <label key={icon} title={icon}>
              <input
                type="radio"
                name={`${id}-icon`}
                checked={look.icon === icon}
                aria-label={icon}
                data-testid={`own-icon-${icon}`}
                onChange={() => onChange({ ...look, icon })}
              />
              <Icon name={icon} size={20} />
            </label>
          ))}
        </div>
      </fieldset>
    </>
  );
}
