/** What a selection offers to be left open, each with a tick; what is ticked has a name, and a number its range. */
import { useId } from "react";

import { type Key, t } from "../../i18n/words";
import { partsOf, title } from "../../model/parts";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { Checkbox } from "../../ui/Checkbox";
import { NumberRange } from "./NumberRange";
import { depthsOf, type Opening, TYPED } from "./openings";

interface OpeningsProps {
  program: string;
  openings: Opening[];
  onChange: (openings: Opening[]) => void;
}

export function Openings({ program, openings, onChange }: OpeningsProps) {
  const depths = depthsOf(openings);
  const rows = openings.map((opening, at) => ({ opening, depth: depths[at] ?? 0 })).filter(({ depth }) => depth >= 0);
  const change = (key: string, to: Partial<Opening>) => {
    onChange(openings.map((one) => (one.key === key ? { ...one, ...to } : one)));
  };
  return (
    <fieldset className="own-openings">
      <legend className="bold">{t("own.open-title")}</legend>
      {rows.length === 0 ? <p className="sheet-note muted small-text">{t("own.open-none")}</p> : null}
      <ul>
        {rows.map(({ opening, depth }) => (
          <Row
            key={opening.key}
            opening={opening}
            depth={depth}
            program={program}
            onChange={(to) => change(opening.key, to)}
          />
        ))}
      </ul>
    </fieldset>
  );
}

interface RowProps {
  opening: Opening;
  depth: number;
  program: string;
  onChange: (to: Partial<Opening>) => void;
}

function Row({ opening, depth, program, onChange }: RowProps) {
  const { offer, on, name } = opening;
  const id = useId();
  const part = useStudio(({ mission, catalogue }) => {
    const found = mission.programs.find((one) => one.name === program);
    const element = found?.vertices.find((one) => one.id === offer.vertex)?.element ?? "";
    return title(partsOf(catalogue, found?.robot ?? "").shape(element));
  });
  const filler = useStudio(({ mission, catalogue }) => {
    const found = mission.programs.find((one) => one.name === program);
    const source = found?.arcs.find((one) => one.target === offer.vertex && one.at === offer.slot)?.source;
    const element = found?.vertices.find((one) => one.id === source)?.element;
    return element === undefined ? "" : title(partsOf(catalogue, found?.robot ?? "").shape(element));
  });
  const now = offer.value || filler || t(`own.kind-${offer.kind}` as Key);
  const slot = text(offer.label, offer.slot);
  const what = offer.slot === "" ? t("own.open-vertex", { part }) : t("own.open-slot", { slot, part });
  return (
    <li style={{ paddingInlineStart: depth * 16 }} data-testid={`opening-${opening.key.replace(" ", "-")}`}>
      <Checkbox checked={on} disabled={offer.is_open} set={(on) => onChange({ on })}>
        <span>{what}</span>
        <span className="muted small-text to-end">{offer.is_open ? t("own.must") : now}</span>
      </Checkbox>
      {on ? (
        <div className="own-opening wrap flex gap-m">
          <label htmlFor={`${id}-name`} className="own-named">
            <span>{t("own.name")}</span>
            <input
              id={`${id}-name`}
              className="field"
              value={name}
              spellCheck={false}
              autoComplete="off"
              maxLength={40}
              aria-label={t("own.open-name", { what })}
              onChange={(event) => onChange({ name: event.target.value })}
            />
          </label>
          {TYPED.includes(offer.kind) ? (
            <NumberRange of={opening} means={offer.meaning} what={name} onChange={onChange} />
          ) : null}
        </div>
      ) : null}
    </li>
  );
}
