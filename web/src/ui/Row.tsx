/** A label and, beside it on the same line, what is typed or chosen. */
import type { ReactNode } from "react";

interface RowProps {
  label: ReactNode;
  className?: string;
  labelClass?: string;
  children: ReactNode;
}

export function Row({ label, className = "", labelClass, children }: RowProps) {
  return (
    <label className={`row ${className}`.trim()}>
      <span className={labelClass}>{label}</span>
      {children}
    </label>
  );
}
