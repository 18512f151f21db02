/** One value that is typed in: a number with a slider, a switch, or a text. */
import { type CSSProperties, useId, useState } from "react";

import { t } from "../../i18n/words";
import { setField } from "../../model/commands/setField";
import type { Field } from "../../model/parts";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import type { Vertex } from "../../model/types";
import { isOn } from "../../model/words";
import type { Drawing } from "../../session/drawing";

interface FieldProps {
  drawing: Drawing;
  vertex: Vertex;
  field: Field;
}

/** A slider with more steps than this says nothing. */
const MOST_STEPS = 1000;

export function FieldRow(props: FieldProps) {
  switch (props.field.kind) {
    case "integer":
      return <NumberRow {...props} />;
    case "boolean":
      return <SwitchRow {...props} />;
    case "text":
      return <TextRow {...props} />;
  }
}

function useSetter({ drawing: { program, parts }, vertex, field }: FieldProps): (value: string) => void {
  const execute = useStudio((state) => state.execute);
  return (value) => {
    const command = setField(program, parts, vertex.id, field.name, value);
    if (command !== null) execute(command);
  };
}

/** A whole number in its range, or null. */
export function wholeNumber(typed: string, { min, max }: Field): number | null {
  const trimmed = typed.trim();
  if (!/^-?[0-9]{1,9}$/.test(trimmed)) return null;
  const value = Number(trimmed);
  return value >= min && value <= max ? value : null;
}

function NumberRow(props: FieldProps) {
  const { vertex, field } = props;
  const set = useSetter(props);
  const id = useId();
  const setting = vertex.settings[field.name] ?? "";
  /** What was typed and is no number of the range: kept on the screen, with the setting it was typed over. */
  const [draft, setDraft] = useState<{ typed: string; over: string } | null>(null);
  const typed = draft?.over === setting ? draft.typed : setting;
  const value = wholeNumber(typed, field);
  const wrong = value === null;
  const label = text(field.label, field.name);
  const help = text(field.help);
  const steps = field.max - field.min;
  const share = steps > 0 ? ((value ?? field.min) - field.min) / steps : 0;

  const change = (next: string) => {
    const number = wholeNumber(next, field);
    setDraft(number === null ? { typed: next, over: setting } : null);
    if (number !== null) set(String(number));
  };

  return (
    <>
      <div className="inspector-row">
        <label className="inspector-label" htmlFor={id}>
          {label}
        </label>
        {steps <= MOST_STEPS ? (
          <input
            type="range"
            className="inspector-slider"
            aria-label={label}
            min={field.min}
            max={field.max}
            value={value ?? field.min}
            style={{ "--share": share } as CSSProperties}
            onChange={(event) => {
              change(event.target.value);
            }}
          />
        ) : (
          <span className="inspector-space" />
        )}
        <span className={wrong ? "inspector-number is-wrong" : "inspector-number"}>
          <input
            id={id}
            type="text"
            inputMode="numeric"
            autoComplete="off"
            data-inspector-field=""
            data-testid={`field-${vertex.id}.${field.name}`}
            aria-invalid={wrong}
            aria-describedby={wrong ? `${id}-wrong` : help === "" ? undefined : `${id}-help`}
            value={typed}
            onChange={(event) => {
              change(event.target.value);
            }}
            onKeyDown={(event) => {
              const by = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
              if (by === 0 || value === null) return;
              event.preventDefault();
              const next = value + by * (event.shiftKey ? 10 : 1);
              change(String(Math.min(field.max, Math.max(field.min, next))));
            }}
          />
          {field.unit === "" ? null : <span className="inspector-unit">{field.unit}</span>}
        </span>
      </div>
      {wrong ? (
        <p className="inspector-wrong" id={`${id}-wrong`} role="alert">
          {t("inspector.whole", { min: field.min, max: field.max })}
        </p>
      ) : help === "" ? null : (
        <p className="inspector-help" id={`${id}-help`}>
          {help}
        </p>
      )}
    </>
  );
}

function SwitchRow(props: FieldProps) {
  const { vertex, field } = props;
  const set = useSetter(props);
  const on = isOn(vertex.settings[field.name] ?? "");
  return (
    <label className="inspector-row">
      <span className="inspector-label">{text(field.label, field.name)}</span>
      <span className="inspector-space" />
      <span className="inspector-unit">{t(on ? "parts.on" : "parts.off")}</span>
      <Switch
        on={on}
        label={text(field.label, field.name)}
        testid={`field-${vertex.id}.${field.name}`}
        toggle={() => {
          set(on ? "0" : "1");
        }}
      />
    </label>
  );
}

interface SwitchProps {
  on: boolean;
  label: string;
  testid: string;
  toggle: () => void;
}

export function Switch({ on, label, testid, toggle }: SwitchProps) {
  return (
    <button
      type="button"
      role="switch"
      className="switch"
      data-inspector-field=""
      data-testid={testid}
      aria-checked={on}
      aria-label={label}
      onClick={toggle}
    />
  );
}

function TextRow(props: FieldProps) {
  const { vertex, field } = props;
  const set = useSetter(props);
  return (
    <label className="inspector-row">
      <span className="inspector-label">{text(field.label, field.name)}</span>
      <input
        type="text"
        className="inspector-text"
        data-inspector-field=""
        data-testid={`field-${vertex.id}.${field.name}`}
        value={vertex.settings[field.name] ?? ""}
        onChange={(event) => {
          set(event.target.value);
        }}
      />
    </label>
  );
}
