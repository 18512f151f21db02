/** A number with its unit: kept with Enter, when it is left, or step by step with the arrows; as before with Escape. */
import { useId, useState } from "react";

interface NumberFieldProps {
  label: string;
  value: number;
  unit?: string;
  min: number;
  max: number;
  step?: number;
  testId: string;
  /** `stepped`: one of several steps that follow each other. */
  keep: (value: number, stepped: boolean) => void;
}

export function NumberField({ label, value, unit = "mm", min, max, step = 10, testId, keep }: NumberFieldProps) {
  const id = useId();
  const [text, setText] = useState(String(value));
  const [shown, setShown] = useState(value);
  if (shown !== value) {
    setShown(value);
    setText(String(value));
  }
  const number = Number(text.trim().replace(",", "."));
  const good = text.trim() !== "" && Number.isFinite(number) && number >= min && number <= max;
  const done = () => {
    if (good && number !== value) keep(number, false);
    else setText(String(value));
  };
  return (
    <span className="world-field">
      <label htmlFor={id}>{label}</label>
      <span className="world-number">
        <input
          id={id}
          className="field"
          inputMode="decimal"
          dir="ltr"
          data-testid={testId}
          aria-invalid={!good}
          value={text}
          onChange={(event) => setText(event.target.value)}
          onBlur={done}
          onKeyDown={(event) => {
            if (event.key === "Enter") {
              done();
            } else if (event.key === "Escape") {
              event.stopPropagation();
              setText(String(value));
            } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
              event.preventDefault();
              const by = (event.key === "ArrowUp" ? 1 : -1) * (event.shiftKey ? 10 : 1) * step;
              const next = Math.min(Math.max((good ? number : value) + by, min), max);
              if (next !== value) keep(next, true);
            }
          }}
        />
        {unit === "" ? null : <small dir="ltr">{unit}</small>}
      </span>
    </span>
  );
}
