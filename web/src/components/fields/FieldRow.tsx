/**
 * One value that is typed in: a number with what fits it, a switch, or a text.
 *
 * The same stands in the inspector and opens under a vertex. Enter and Escape give the focus back to the graph: Enter with
 * the value, or with the nearest one that can be; Escape with the value that was there before.
 */
import "./fields.css";

import { type KeyboardEvent, useEffect, useId, useRef, useState } from "react";

import { t } from "../../i18n/words";
import { setField, stepsSince } from "../../model/commands/setField";
import { figures, inWords, storedNumber, unitOf } from "../../model/meaning";
import type { Field } from "../../model/parts";
import { execute, useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import type { Vertex } from "../../model/types";
import { isOn } from "../../model/words";
import type { Drawing } from "../../session/drawing";
import { useView } from "../../session/view";
import { Choices } from "./Choices";
import { Dial } from "./Dial";
import { Piano } from "./Piano";
import { Ruler } from "./Ruler";
import { Slider } from "./Slider";
import { isRounded, numberTyped, within } from "./number-text";

export interface FieldProps {
  drawing: Drawing;
  vertex: Vertex;
  field: Field;
  /** What is typed in at first, when the field takes the focus by itself; undefined where it does not. */
  typed?: string;
  /** What Enter and Escape do when the value is kept or put back; goes to the graph unless told. */
  done?: () => void;
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
  return (value) => execute(setField(program, parts, vertex.id, field.name, value));
}

function toGraph(): void {
  useView.getState().viewport?.focus();
}

/** Enter and Escape in any field; `keep` is done before Enter goes. What there was before is what had the focus first. */
function useLeaving({ drawing, vertex, field, done = toGraph }: FieldProps, set: (value: string) => void) {
  const setting = vertex.settings[field.name] ?? "";
  const before = useRef(setting);
  /** What was typed and is not wanted leaves no step that undo would go through. */
  const takeBack = () => {
    if (setting === before.current) return;
    const { history, undo } = useStudio.getState();
    const steps = stepsSince(history.past, drawing.program, vertex.id, field.name, before.current);
    for (let step = 0; step < steps; step++) undo();
    if (steps === 0) set(before.current);
  };
  return {
    onFocus: () => {
      before.current = setting;
    },
    leave: (event: KeyboardEvent, keep?: () => void): boolean => {
      if (event.nativeEvent.isComposing || (event.key !== "Enter" && event.key !== "Escape")) return false;
      event.preventDefault();
      event.stopPropagation();
      if (event.key === "Escape") takeBack();
      else keep?.();
      done();
      return true;
    },
  };
}

function NumberRow(props: FieldProps) {
  const { vertex, field } = props;
  const set = useSetter(props);
  const { onFocus, leave } = useLeaving(props, set);
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const setting = vertex.settings[field.name] ?? "";
  /** What is being typed, with the setting that it was typed over or became. */
  const { typed: first } = props;
  const [draft, setDraft] = useState(() => (first ? { typed: first, over: setting } : null));
  const stored = storedNumber(setting);
  const kept = stored === null ? setting : figures(field, stored);
  const typed = draft?.over === setting ? draft.typed : kept;
  const meant = draft?.over === setting ? numberTyped(typed, field) : stored;
  const value = meant === null ? null : within(meant, field);
  const wrong = meant === null || value !== meant;
  const label = text(field.label, field.name);
  const help = text(field.help);
  const shown = value ?? field.min;

  const change = (next: string) => {
    const number = numberTyped(next, field);
    const right = number !== null && within(number, field) === number;
    setDraft({ typed: next, over: right ? String(number) : setting });
    if (right) set(String(number));
  };
  const put = (number: number) => {
    setDraft(null);
    set(String(number));
  };
  const keep = () => {
    if (value !== null) put(value);
    else setDraft(null);
  };

  const begin = useRef(change);
  useEffect(() => {
    const element = input.current;
    if (first === undefined || element === null) return;
    element.focus({ preventScroll: true });
    if (first === "") element.select();
    else {
      // What is typed next comes behind it.
      element.setSelectionRange(first.length, first.length);
      begin.current(first);
    }
  }, [first]);

  const control = { field, value: shown, label, set: put, leave, onFocus };
  const box = (
    <span
      className={
        wrong ? "field-number row rigid is-wrong to-end gap-s typed" : "field-number row rigid to-end gap-s typed"
      }
    >
      <input
        ref={input}
        className="bare medium"
        id={id}
        type="text"
        inputMode={field.scale === 1 ? "numeric" : "decimal"}
        autoComplete="off"
        data-inspector-field=""
        data-testid={`field-${vertex.id}.${field.name}`}
        aria-invalid={wrong}
        aria-describedby={`${id}-help`}
        value={typed}
        onFocus={onFocus}
        onChange={(event) => change(event.target.value)}
        onBlur={() => {
          if (!wrong) setDraft(null);
        }}
        onKeyDown={(event) => {
          if (leave(event, keep)) return;
          const by = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
          if (by === undefined || value === null) return;
          event.preventDefault();
          put(within(value + by * (event.shiftKey ? 10 : 1), field));
        }}
      />
      {unitOf(field) === "" ? null : <span className="muted rigid">{unitOf(field)}</span>}
    </span>
  );
  return (
    <div className="field-row row wrap" data-field={field.meaning?.field ?? ""}>
      <label className="field-label muted small-text rigid" htmlFor={id}>
        {label}
      </label>
      <Control {...props} control={control} />
      {isNamed(field) ? null : box}
      <Says id={`${id}-help`} field={field} typed={typed} meant={meant} isDraft={draft !== null} help={help} />
    </div>
  );
}

/** Whether each number of the range has a name, so that none has to be typed. */
function isNamed({ min, max, meaning }: Field): boolean {
  return (meaning?.choices?.length ?? 0) === max - min + 1;
}

interface SaysProps {
  id: string;
  field: Field;
  typed: string;
  meant: number | null;
  isDraft: boolean;
  help: string;
}

/** What is wrong with what was typed and what Enter makes of it, or what the number is for. */
function Says({ id, field, typed, meant, isDraft, help }: SaysProps) {
  const [min, max] = [inWords(field, field.min), inWords(field, field.max)];
  const wrong =
    meant === null
      ? t(field.scale === 1 ? "inspector.whole" : "fields.number", { min, max })
      : meant > field.max
        ? t("fields.at-most", { most: max })
        : meant < field.min
          ? t("fields.at-least", { least: min })
          : "";
  if (wrong !== "")
    return (
      <p className="field-wrong" id={id} role="alert">
        {wrong}
      </p>
    );
  const rounded = meant !== null && isDraft && isRounded(typed, meant, field);
  const says = rounded ? t("fields.nearest", { words: inWords(field, meant) }) : help;
  return says === "" ? null : (
    <p className="field-help muted small-text" id={id}>
      {says}
    </p>
  );
}

export interface ControlProps {
  field: Field;
  value: number;
  label: string;
  set: (value: number) => void;
  leave: (event: KeyboardEvent, keep?: () => void) => boolean;
  onFocus: () => void;
}

/** What the number is set with, besides typing. */
function Control({ control, drawing, vertex, typed }: FieldProps & { control: ControlProps }) {
  const { field } = control;
  const look = field.meaning?.field ?? "";
  if (look === "dial") return <Dial {...control} />;
  if (look === "ruler") return <Ruler {...control} sensor={drawing.parts.shape(vertex.element).object} />;
  if (look === "piano") return <Piano {...control} />;
  if ((field.meaning?.choices?.length ?? 0) > 0)
    return (
      <Choices
        {...control}
        testid={`choices-${vertex.id}.${field.name}`}
        focused={typed !== undefined && isNamed(field)}
      />
    );
  const steps = field.max - field.min;
  return look === "time" || steps <= MOST_STEPS ? <Slider {...control} /> : <span className="grow" />;
}

function SwitchRow(props: FieldProps) {
  const { vertex, field } = props;
  const set = useSetter(props);
  const { leave, onFocus } = useLeaving(props, set);
  const on = isOn(vertex.settings[field.name] ?? "");
  return (
    <label className="field-row row wrap">
      <span className="field-label muted small-text rigid">{text(field.label, field.name)}</span>
      <span className="grow" />
      <span className="muted rigid">{t(on ? "parts.on" : "parts.off")}</span>
      <Switch
        on={on}
        label={text(field.label, field.name)}
        testid={`field-${vertex.id}.${field.name}`}
        focused={props.typed !== undefined}
        onFocus={onFocus}
        onKeyDown={(event) => {
          if (event.key === "Escape" || props.done !== undefined) leave(event);
        }}
        toggle={() => set(on ? "0" : "1")}
      />
    </label>
  );
}

interface SwitchProps {
  on: boolean;
  label: string;
  testid: string;
  toggle: () => void;
  /** Whether it takes the focus when it appears. */
  focused?: boolean;
  onFocus?: () => void;
  onKeyDown?: (event: KeyboardEvent) => void;
}

export function Switch({ on, label, testid, toggle, focused = false, onFocus, onKeyDown }: SwitchProps) {
  const button = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (focused) button.current?.focus({ preventScroll: true });
  }, [focused]);
  return (
    <button
      ref={button}
      type="button"
      role="switch"
      className="switch rigid relative"
      data-inspector-field=""
      data-testid={testid}
      aria-checked={on}
      aria-label={label}
      onClick={toggle}
      onFocus={onFocus}
      onKeyDown={onKeyDown}
    />
  );
}

function TextRow(props: FieldProps) {
  const { vertex, field, typed } = props;
  const set = useSetter(props);
  const { leave, onFocus } = useLeaving(props, set);
  const input = useRef<HTMLInputElement>(null);
  useEffect(() => {
    if (typed !== undefined) input.current?.select();
  }, [typed]);
  return (
    <label className="field-row row wrap">
      <span className="field-label muted small-text rigid">{text(field.label, field.name)}</span>
      <input
        ref={input}
        type="text"
        className="field-text grow typed"
        data-inspector-field=""
        data-testid={`field-${vertex.id}.${field.name}`}
        value={vertex.settings[field.name] ?? ""}
        onFocus={onFocus}
        onKeyDown={leave}
        onChange={(event) => set(event.target.value)}
      />
    </label>
  );
}
