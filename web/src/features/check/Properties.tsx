/** The properties that the mission asks for itself: each a sentence with holes; added, changed and removed here. */
import { Said } from "../../i18n/Said";
import { type Key, t } from "../../i18n/words";
import { freePropertyName, setProperties } from "../../model/commands/changeProperties";
import { useStudio } from "../../model/studio";
import { typedName } from "../../model/typed-name";
import type { AskedProperty } from "../../model/types";
import { Button } from "../../ui/Button";
import { Tool } from "../../ui/Tool";
import { ConditionField } from "./ConditionField";

type Form = AskedProperty["form"];

/** The words before each of the holes of a form. */
const WORDS: Readonly<Record<Form, readonly Key[]>> = {
  never: ["check.never"],
  after: ["check.after", "check.after-eventually"],
  eventually: ["check.eventually"],
  stays: ["check.stays-once", "check.stays-until"],
};
const FORMS = Object.keys(WORDS) as readonly Form[];
const NONE: readonly AskedProperty[] = [];
const CODE = "mission-property";

function put(change: (before: readonly AskedProperty[]) => readonly AskedProperty[]): void {
  const { mission, execute } = useStudio.getState();
  const command = setProperties(mission, change(mission.properties ?? NONE));
  if (command !== null) execute(command);
}

function Row({ one, at }: { one: AskedProperty; at: number }) {
  const change = (what: Partial<AskedProperty>) =>
    put((before) => before.map((other, index) => (index === at ? { ...other, ...what } : other)));
  return (
    <li className="check-property row wrap small-text" data-testid={`property-${String(at)}`}>
      <input
        className="field check-name"
        key={one.name}
        type="text"
        maxLength={100}
        aria-label={t("check.property-name")}
        data-testid={`property-name-${String(at)}`}
        defaultValue={one.name}
        onBlur={(event) => {
          const name = typedName(event.target.value);
          if (name === "") event.target.value = one.name;
          else change({ name });
        }}
      />
      {WORDS[one.form].map((word, hole) => {
        const part = hole === 0 ? "first" : "second";
        const value = one[part] ?? "";
        return (
          <span className="check-hole row" key={word}>
            <span>{t(word)}</span>
            <ConditionField
              key={value}
              label={`${one.name}: ${t(word)}`}
              testId={`property-${part}-${String(at)}`}
              value={value}
              keep={(text) => change({ [part]: text })}
            />
          </span>
        );
      })}
      <Tool
        small
        icon="trash-2"
        label={t("check.property-remove", { name: one.name })}
        testId={`property-remove-${String(at)}`}
        onClick={() => put((before) => before.filter((_, index) => index !== at))}
      />
    </li>
  );
}

function add(form: Form): void {
  put((before) => [...before, { name: freePropertyName(before), form, first: "", second: "" }]);
}

export function Properties() {
  const properties = useStudio((studio) => studio.mission.properties ?? NONE);
  const report = useStudio((studio) => studio.report);
  const wrong = report?.problems.filter(({ code }) => code === CODE) ?? [];
  return (
    <section className="check-properties" aria-labelledby="check-properties" data-testid="check-properties">
      <h3 id="check-properties">{t("check.own")}</h3>
      {properties.length === 0 ? null : (
        <ul>
          {properties.map((one, at) => (
            <Row key={at} one={one} at={at} />
          ))}
        </ul>
      )}
      {wrong.map(({ message, help }) => (
        <p key={message} className="check-warning" role="status" data-testid="property-wrong">
          <Said text={message} />. <Said text={help} />
        </p>
      ))}
      <p className="check-add row wrap small-text">
        <span className="check-note muted">{t("check.add")}</span>
        {FORMS.map((form) => (
          <Button
            icon="plus"
            iconSize={14}
            className="check-form"
            key={form}

            testId={`property-add-${form}`}
            onClick={() => add(form)}
          >
            {t(`check.form-${form}`)}
          </Button>
        ))}
      </p>
    </section>
  );
}
