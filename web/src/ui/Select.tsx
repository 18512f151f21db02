/** A choice from a list. A value that is not in the list stays chosen, under words of its own. */
interface SelectProps {
  label: string;
  testId: string;
  value: string;
  options: readonly (string | readonly [value: string, words: string])[];
  /** What stands for a value that is not in the list; the value itself unless told. */
  missing?: string;
  /** Whether the value cannot stay; whether it is not in the list unless told. */
  wrong?: boolean;
  disabled?: boolean;
  className?: string;
  title?: string;
  keep: (value: string) => void;
}

export function Select({
  label,
  testId,
  value,
  options,
  missing = value,
  wrong,
  disabled = false,
  className = "field",
  title,
  keep,
}: SelectProps) {
  const rows = options.map((one): readonly [string, string] => (typeof one === "string" ? [one, one] : one));
  const known = rows.some(([one]) => one === value);
  return (
    <select
      className={className}
      disabled={disabled}
      title={title}
      data-testid={testId}
      aria-label={label}
      aria-invalid={wrong ?? !known}
      value={value}
      onChange={(event) => keep(event.target.value)}
    >
      {known ? null : <option value={value}>{missing}</option>}
      {rows.map(([one, words]) => (
        <option key={one} value={one}>
          {words}
        </option>
      ))}
    </select>
  );
}
