/** A field for words that things are found by. The first Escape empties it; what closes around it needs the next one. */
import type { KeyboardEvent, Ref } from "react";

import { Icon } from "../theme";
import "./search-field.css";

interface SearchFieldProps {
  label: string;
  testId: string;
  value: string;
  set: (value: string) => void;
  className?: string;
  field?: Ref<HTMLInputElement>;
  onKeyDown?: (event: KeyboardEvent) => void;
}

export function SearchField({ label, testId, value, set, className = "", field, onKeyDown }: SearchFieldProps) {
  return (
    <label className={`search-field ${className}`.trim()}>
      <Icon name="search" size={16} />
      <span className="only-spoken">{label}</span>
      <input
        ref={field}
        className="field"
        type="search"
        placeholder={label}
        data-testid={testId}
        maxLength={100}
        spellCheck={false}
        autoComplete="off"
        value={value}
        onChange={(event) => set(event.target.value)}
        onKeyDown={(event) => {
          onKeyDown?.(event);
          if (event.key !== "Escape" || value === "") return;
          event.stopPropagation();
          event.preventDefault();
          set("");
        }}
      />
    </label>
  );
}
