/** A name that can be typed over: kept with Enter or when it is left, as before with Escape; why not is said under it. */
import { useEffect, useId, useRef, useState } from "react";

import { typedName } from "../model/typed-name";
import { Icon } from "../theme";

interface NameCellProps {
  name: string;
  label: string;
  testId: string;
  /** Why a name cannot be, or "". */
  wrong: (name: string) => string;
  keep: (name: string) => void;
}

export function NameCell({ name, label, testId, wrong, keep }: NameCellProps) {
  const [text, setText] = useState(name);
  const [shown, setShown] = useState(name);
  const said = useId();
  const given = useRef(false);
  if (shown !== name) {
    setShown(name);
    setText(name);
  }
  useEffect(() => {
    given.current = false;
  }, [name]);
  const wanted = typedName(text);
  const why = wanted === name ? "" : wrong(wanted);
  const done = () => {
    if (wanted === name || why !== "") setText(name);
    else if (!given.current) {
      given.current = true;
      keep(wanted);
    }
  };
  return (
    <span>
      <input
        className="field"
        data-testid={testId}
        aria-label={label}
        aria-invalid={why !== ""}
        aria-describedby={why === "" ? undefined : said}
        value={text}
        spellCheck={false}
        autoComplete="off"
        onChange={(event) => {
          given.current = false;
          setText(event.target.value);
        }}
        onBlur={done}
        onKeyDown={(event) => {
          if (event.key === "Enter" && why === "") done();
          else if (event.key === "Escape" && text !== name) {
            event.stopPropagation();
            setText(name);
          }
        }}
      />
      {why === "" ? null : (
        <span className="field-wrong" id={said} role="alert">
          <Icon name="triangle-alert" size={14} /> {why}
        </span>
      )}
    </span>
  );
}
