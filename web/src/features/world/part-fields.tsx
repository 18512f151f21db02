/** Fields that several kinds of things have: numbers in mm, a choice, a colour, a count. */
import type { ComponentProps } from "react";

import { type Key, t } from "../../i18n/words";
import type { OwnWorld } from "../../model/types";
import { nameOf } from "../../model/world/names";
import { LARGEST_MM, type Part, type PartReference, tidy } from "../../model/world/part-reference";
import { useShown } from "../../session/simple-view";
import { change } from "../../session/world-edits";
import { Select } from "../../ui/Select";
import { NumberField } from "./NumberField";

const MOST = 65535;
const COORDINATES: readonly string[] = ["x_mm", "y_mm"];

export interface PartProps<P> {
  world: OwnWorld;
  thing: PartReference;
  part: P;
  /** The part as it is to be from now on. `stepped`: one of several steps of the field `what` that follow each other. */
  keep: (after: P, what?: string, stepped?: boolean) => void;
}

export function set(world: OwnWorld, thing: PartReference, after: OwnWorld, what = "", stepped = false): void {
  const label = t("command.edit", { name: nameOf(world, thing) });
  change(label, after, stepped ? `world ${thing.kind} ${String(thing.at)} ${what}` : undefined);
}

/** Fields that are numbers in mm, by their names in the part. */
export function Numbers<P extends Part<PartReference["kind"]>>({
  part,
  keep,
  names,
  least = 0,
}: PartProps<P> & { names: readonly (keyof P & string)[]; least?: number }) {
  const places = useShown("places");
  const shown = names.filter((name) => places || !COORDINATES.includes(name));
  if (shown.length === 0) return null;
  return (
    <div className="world-fields gap-m">
      {shown.map((name) => (
        <NumberField
          key={name}
          label={t(`world.${name}` as Key)}
          value={part[name] as number}
          min={least}
          max={LARGEST_MM}
          testId={`world-${name}`}
          keep={(value, stepped) => keep({ ...part, [name]: tidy(value) }, name, stepped)}
        />
      ))}
    </div>
  );
}

/** A choice with its label before it. */
export function Choice(props: ComponentProps<typeof Select>) {
  return (
    <label className="world-field column small-text slim gap-2xs">
      <span>{props.label}</span>
      <Select {...props} />
    </label>
  );
}

export function Colour<P extends Part<"line"> | Part<"floor">>({ part, keep }: PartProps<P>) {
  return (
    <Choice
      label={t("world.colour")}
      testId="world-colour"
      value={part.colour}
      options={(["red", "green", "blue"] as const).map((one) => [one, t(`world.${one}` as Key)])}
      keep={(colour) => keep({ ...part, colour })}
    />
  );
}

export function Count({
  label,
  value,
  name,
  keep,
}: {
  label: string;
  value: number;
  name: string;
  keep: (n: number) => void;
}) {
  return (
    <NumberField
      label={label}
      value={value}
      unit=""
      min={0}
      max={MOST}
      step={1}
      whole
      testId={`world-${name}`}
      keep={keep}
    />
  );
}
