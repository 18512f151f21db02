/** A label and, under it, what is typed or chosen. */
import type { ReactNode } from "react";

interface FieldProps {
  label: string;
  className?: string;
  children: ReactNode;
}

export function Field({ label, className, children }: FieldProps) {
  return (
    <label className={className}>
      <span className="field-title muted small-text rigid">{label}</span>
      {children}
    </label>
  );
}
