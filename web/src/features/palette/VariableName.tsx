/** A variable's name, typed over in its row of the palette; why a name cannot be is said under it. */
import "./variables.css";

import { useEffect, useId, useRef, useState } from "react";

import { failureWords } from "../../api/refusal";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { typedName } from "../../model/typed-name";
import { keepVariable, type Named, ownVariable, stopRenaming, wantedLike } from "../../session/variables";

export function VariableName({ of, done }: { of: Named; done: (name: string) => void }) {
  const [text, setText] = useState(of.name);
  const [why, setWhy] = useState("");
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  const busy = useRef(false);
  useEffect(() => {
    input.current?.focus();
    input.current?.select();
  }, []);
  const said = useRef<HTMLSpanElement>(null);
  useEffect(() => {
    said.current?.scrollIntoView({ block: "nearest" });
  }, [why]);
  const stop = (name: string) => {
    stopRenaming();
    done(name);
  };
  const keep = async () => {
    const own = ownVariable(of);
    const name = typedName(text);
    if (own === undefined || name === of.name) return stop(of.name);
    if (busy.current) return;
    busy.current = true;
    try {
      await keepVariable(wantedLike(of.robot, own, name));
      stop(name);
    } catch (cause) {
      setWhy(failureWords(cause));
      input.current?.focus();
    }
    busy.current = false;
  };
  return (
    <span className="variable-rename column">
      <input
        ref={input}
        className="field"
        dir="auto"
        spellCheck={false}
        autoComplete="off"
        data-testid="variable-rename"
        aria-label={t("variable.name")}
        aria-invalid={why !== ""}
        aria-describedby={why === "" ? undefined : id}
        value={text}
        onChange={(event) => {
          setWhy("");
          setText(event.target.value);
        }}
        onClick={(event) => event.stopPropagation()}
        onDoubleClick={(event) => event.stopPropagation()}
        onBlur={() => {
          if (why === "") void keep();
          else stop(of.name);
        }}
        onKeyDown={(event) => {
          event.stopPropagation();
          if (event.key === "Enter") void keep();
          else if (event.key === "Escape") stop(of.name);
        }}
      />
      {why === "" ? null : (
        <span className="variable-why small-text regular" id={id} role="alert" ref={said}>
          <Said text={why} />
        </span>
      )}
    </span>
  );
}
