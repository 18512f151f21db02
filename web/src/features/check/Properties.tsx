/** The properties that the mission asks for itself: each a sentence with holes; added, changed and removed here. */
import { NumberInput } from "../../components/fields/NumberInput";
import { Said } from "../../i18n/Said";
import { type Key, t } from "../../i18n/words";
import { freePropertyName, setProperties } from "../../model/commands/changeProperties";
import { execute, useStudio } from "../../model/studio";
import { typedName } from "../../model/typed-name";
import type { AskedProperty } from "../../model/types";
import { Button } from "../../ui/Button";
import { Select } from "../../ui/Select";
import { Tool } from "../../ui/Tool";
import { ConditionField } from "./ConditionField";

type Form = AskedProperty["form"];

/** The words before each of the holes of a form. The second hole of `never` may stay empty. */
const WORDS: Readonly<Record<Form, readonly Key[]>> = {
  never: ["check.never", "check.never-while"],
  after: ["check.after", "check.after-eventually"],
  eventually: ["check.eventually"],
  stays: ["check.stays-once", "check.stays-until"],
  holds: ["check.stays-once"],
  "at-most": ["check.at-most"],
  first: ["check.first", "check.first-before"],
  again: ["check.again-and-again"],
  visit: ["check.visit"],
};
const ORDERS = ["any", "given", "turn"] as const;
/** The forms that may say in how many seconds something comes. */
const TIMED: readonly Form[] = ["after", "eventually", "again", "visit"];
const [MOST_SECONDS, MOST_TIMES] = [1_000_000, 100];
const [USUAL_SECONDS, USUAL_TIMES] = [5, 1];
const FORMS = Object.keys(WORDS) as readonly Form[];
const NONE: readonly AskedProperty[] = [];
const CODE = "mission-property";

function put(change: (before: readonly AskedProperty[]) => readonly AskedProperty[]): void {
  const { mission } = useStudio.getState();
  execute(setProperties(mission, change(mission.properties ?? NONE)));
}

interface EndProps {
  one: AskedProperty;
  at: number;
  change: (what: Partial<AskedProperty>) => void;
}

/** What stands behind the holes: an order, how often, how long. */
function End({ one, at, change }: EndProps) {
  const seconds = one.seconds ?? 0;
  const name = (words: string) => `${one.name}: ${words}`;
  return (
    <>
      {one.form === "visit" ? (
        <Select
          label={name(t("check.order"))}
          testId={`property-order-${String(at)}`}
          value={one.order ?? "any"}
          options={ORDERS.map((order) => [order, t(`check.order-${order}`)] as const)}
          keep={(order) => change({ order: ORDERS.find((known) => known === order) ?? "any" })}
        />
      ) : null}
      {one.form === "at-most" ? (
        <label className="row">
          <span>{t("check.most-times")}</span>
          <NumberInput
            className="field check-number"
            label={name(t("check.most-times"))}
            testId={`property-times-${String(at)}`}
            min={0}
            max={MOST_TIMES}
            whole
            value={one.times ?? 0}
            keep={(times) => change({ times })}
          />
        </label>
      ) : null}
      {one.form === "holds" ? (
        <label className="row">
          <span>{t("check.for")}</span>
          <NumberInput
            className="field check-number"
            label={name(t("check.for"))}
            testId={`property-seconds-${String(at)}`}
            min={0}
            max={MOST_SECONDS}
            value={seconds}
            keep={(kept) => change({ seconds: kept })}
          />
        </label>
      ) : null}
      {TIMED.includes(one.form) ? (
        <label className="row">
          <span>{t("check.within")}</span>
          <NumberInput
            className="field check-number"
            label={name(t("check.within"))}
            testId={`property-seconds-${String(at)}`}
            min={0}
            max={MOST_SECONDS}
            optional
            placeholder={t("check.within-any")}
            value={seconds > 0 ? seconds : null}
            keep={(kept) => change({ seconds: kept ?? 0 })}
          />
        </label>
      ) : null}
    </>
  );
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
      <End one={one} at={at} change={change} />
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
  const numbers = { seconds: form === "holds" ? USUAL_SECONDS : 0, times: form === "at-most" ? USUAL_TIMES : 0 };
  put((before) => [
    ...before,
    { name: freePropertyName(before), form, first: "", second: "", ...numbers, order: "any" },
  ]);
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
        <p key={message} className="warning" role="status" data-testid="property-wrong">
          <Said text={message} />. <Said text={help} />
        </p>
      ))}
      <p className="row wrap small-text gap-m">
        <span className="muted">{t("check.add")}</span>
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
