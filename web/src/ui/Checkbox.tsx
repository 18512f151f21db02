/** A box to tick, or with `type="radio"` one of several to choose, and its words. */
import type { ComponentProps, ReactNode } from "react";

interface CheckboxProps extends Omit<ComponentProps<"input">, "onChange" | "className" | "children"> {
  className?: string;
  testId?: string;
  set: (checked: boolean) => void;
  children: ReactNode;
}

export function Checkbox({ className = "", type = "checkbox", testId, set, children, ...rest }: CheckboxProps) {
  return (
    <label className={`row ${className}`.trim()}>
      <input type={type} data-testid={testId} onChange={(event) => set(event.target.checked)} {...rest} />
      {children}
    </label>
  );
}
