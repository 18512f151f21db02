/** A variable as a form at the foot of the palette: for a new one, or for one of the mission's that is to be otherwise. */
import { type FormEvent, useEffect, useId, useRef, useState } from "react";

import { failureWords } from "../../api/refusal";
import { readWhole } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { closeForm, keepVariable, ownVariable } from "../../session/variables";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { Field } from "../../ui/Field";
import { Select } from "../../ui/Select";

const USUAL = { type: "integer", min: "0", max: "100", initial: "0", shared: false } as const;

interface Typed {
  name: string;
  type: "integer" | "boolean";
  min: string;
  max: string;
  initial: string;
  shared: boolean;
}

function begin(robot: string, was: string, name: string): Typed {
  const own = was === "" ? undefined : ownVariable({ robot, name: was });
  if (own === undefined) return { ...USUAL, name };
  const { type, min, max, initial, shared } = own;
  return type === "boolean"
    ? { ...USUAL, name, type, initial: String(initial), shared }
    : { name, type, min: String(min), max: String(max), initial: String(initial), shared };
}

export function VariableForm({ robot, was, name }: { robot: string; was: string; name: string }) {
  const [typed, setTyped] = useState(() => begin(robot, was, name));
  const [why, setWhy] = useState("");
  const [back] = useState(() => document.activeElement);
  const label = useStudio((studio) => studio.catalogue.robots.find((one) => one.name === robot)?.label);
  const first = useRef<HTMLInputElement>(null);
  const id = useId();
  const isNumber = typed.type === "integer";

  useEffect(() => {
    first.current?.focus();
    first.current?.select();
  }, []);

  const close = () => {
    closeForm();
    if (back instanceof HTMLElement && back.isConnected) back.focus();
  };
  const change = (part: Partial<Typed>) => {
    setWhy("");
    setTyped((before) => ({ ...before, ...part }));
  };
  const keep = async () => {
    const numbers = [typed.min, typed.max, typed.initial].map(readWhole);
    if (isNumber && numbers.includes(null)) {
      setWhy(t("variable.whole"));
      return;
    }
    const [min = 0, max = 1, initial = 0] = isNumber
      ? numbers.map((one) => one ?? 0)
      : [0, 1, typed.initial === "0" ? 0 : 1];
    try {
      await keepVariable({ robot, was, name: typed.name, type: typed.type, min, max, initial, shared: typed.shared });
      if (was === "") closeForm();
      else close();
    } catch (cause) {
      setWhy(failureWords(cause));
    }
  };
  const title = was === "" ? t("variable.new") : t("variable.change", { name: was });
  const number = (part: "min" | "max" | "initial", words: string) => (
    <Field label={words}>
      <input
        className="field"
        inputMode="numeric"
        dir="ltr"
        data-testid={`variable-${part}`}
        value={typed[part]}
        onChange={(event) => change({ [part]: event.target.value })}
      />
    </Field>
  );

  return (
    <form
      className="variable-form column surface gap-m"
      data-testid="variable-form"
      aria-labelledby={`${id}-title`}
      onSubmit={(event: FormEvent) => {
        event.preventDefault();
        void keep();
      }}
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.preventDefault();
        event.stopPropagation();
        close();
      }}
    >
      <h2 id={`${id}-title`} className="panel-title">
        {title}
      </h2>
      <p>{t("variable.of", { robot: text(label ?? {}, robot) })}</p>
      <Field label={t("variable.name")}>
        <input
          className="field"
          ref={first}
          dir="auto"
          spellCheck={false}
          autoComplete="off"
          data-testid="variable-name"
          aria-invalid={why !== ""}
          aria-describedby={`${id}-why`}
          value={typed.name}
          onChange={(event) => change({ name: event.target.value })}
        />
      </Field>
      <Field label={t("variable.type")}>
        <Select
          label={t("variable.type")}
          testId="variable-type"
          value={typed.type}
          options={[
            ["integer", t("variable.integer")],
            ["boolean", t("variable.boolean")],
          ]}
          keep={(type) => change({ type: type as Typed["type"], initial: "0" })}
        />
      </Field>
      <div className="variable-numbers gap-m">
        {isNumber ? (
          <>
            {number("min", t("variable.from"))}
            {number("max", t("variable.to"))}
            {number("initial", t("variable.initial"))}
          </>
        ) : (
          <Field label={t("variable.initial")}>
            <Select
              label={t("variable.initial")}
              testId="variable-initial"
              value={typed.initial}
              options={[
                ["0", t("variable.no")],
                ["1", t("variable.yes")],
              ]}
              wrong={false}
              keep={(initial) => change({ initial })}
            />
          </Field>
        )}
      </div>
      <Checkbox
        className="variable-shared finger"
        testId="variable-shared"
        checked={typed.shared}
        set={(shared) => change({ shared })}
      >
        {t("variable.shared")}
      </Checkbox>
      <p className="variable-why small-text regular" id={`${id}-why`} role="alert" data-testid="variable-why">
        {why === "" ? null : (
          <>
            <Icon name="triangle-alert" size={14} /> <Said text={why} />
          </>
        )}
      </p>
      <div className="wrap flex gap-m justify-end">
        <Button testId="variable-cancel" onClick={close}>
          {t("variable.cancel")}
        </Button>
        <Button className="variable-keep bold" type="submit" testId="variable-keep">
          {t(was === "" ? "variable.add" : "variable.keep")}
        </Button>
      </div>
    </form>
  );
}
