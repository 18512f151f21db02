/** A condition as text, with what may stand next in a list that arrows walk and Enter takes. */
import { type KeyboardEvent, useEffect, useId, useRef, useState } from "react";
import { flushSync } from "react-dom";

import { useStudio } from "../../model/studio";
import { type Suggestion, suggest } from "./suggest";

interface FieldProps {
  label: string;
  testId: string;
  value: string;
  keep: (value: string) => void;
}

export function ConditionField({ label, testId, value, keep }: FieldProps) {
  const id = useId();
  const field = useRef<HTMLInputElement>(null);
  const [text, setText] = useState(value);
  const [rows, setRows] = useState<readonly Suggestion[]>([]);
  const [at, setAt] = useState(0);
  const list = useRef<HTMLSpanElement>(null);
  useEffect(() => {
    if (rows.length > 0) list.current?.scrollIntoView({ block: "nearest" });
  }, [rows]);

  const look = (typed: string, caret: number) => {
    const { mission, catalogue } = useStudio.getState();
    setRows(suggest(typed.slice(0, caret), mission, catalogue));
    setAt(0);
  };
  const type = (typed: string) => {
    setText(typed);
    look(typed, field.current?.selectionStart ?? typed.length);
  };
  const take = (row: Suggestion) => {
    const caret = field.current?.selectionStart ?? text.length;
    const after = text.slice(0, row.from) + row.text + text.slice(caret);
    const place = row.from + row.text.length;
    // At once, and the caret with it: the next letter may be there before the page is drawn again.
    flushSync(() => {
      setText(after);
      look(after, place);
    });
    field.current?.setSelectionRange(place, place);
  };
  const pressed = (event: KeyboardEvent) => {
    const open = rows.length > 0;
    const by = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    const row = rows[at];
    if (open && by !== 0) setAt((at + by + rows.length) % rows.length);
    else if (open && event.key === "Escape") setRows([]);
    else if (open && event.key === "Enter" && row !== undefined) take(row);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <span className="check-field grow relative">
      <input
        className="field"
        ref={field}
        type="text"
        role="combobox"
        spellCheck={false}
        autoComplete="off"
        dir="ltr"
        maxLength={1000}
        aria-label={label}
        aria-expanded={rows.length > 0}
        aria-controls={`${id}-list`}
        aria-autocomplete="list"
        {...(rows.length > 0 ? { "aria-activedescendant": `${id}-${String(at)}` } : {})}
        data-testid={testId}
        value={text}
        onChange={(event) => type(event.target.value)}
        onFocus={(event) => look(text, event.target.selectionStart ?? text.length)}
        onBlur={() => {
          setRows([]);
          keep(text.trim());
        }}
        onKeyDown={pressed}
      />
      <span
        className="check-suggestions wrap flex gap-xs"
        role="listbox"
        id={`${id}-list`}
        aria-label={label}
        hidden={rows.length === 0}
      >
        {rows.map((row, index) => (
          <span
            key={row.text}
            role="option"
            id={`${id}-${String(index)}`}
            aria-selected={index === at}
            onMouseDown={(event) => {
              event.preventDefault();
              take(row);
            }}
          >
            <code>{row.text}</code>
          </span>
        ))}
      </span>
    </span>
  );
}
