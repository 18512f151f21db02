/** A number with its label and its unit. */
import { useId } from "react";

import { NumberInput } from "../../components/fields/NumberInput";

interface NumberFieldProps {
  label: string;
  value: number;
  unit?: string;
  min: number;
  max: number;
  step?: number;
  whole?: boolean;
  testId: string;
  /** `stepped`: one of several steps that follow each other. */
  keep: (value: number, stepped: boolean) => void;
}

export function NumberField({ label, unit = "mm", step = 10, ...number }: NumberFieldProps) {
  const id = useId();
  return (
    <span className="world-field column small-text slim gap-2xs">
      <label htmlFor={id}>{label}</label>
      <span className="world-number row gap-xs">
        <NumberInput id={id} step={step} {...number} />
        {unit === "" ? null : <small dir="ltr">{unit}</small>}
      </span>
    </span>
  );
}
