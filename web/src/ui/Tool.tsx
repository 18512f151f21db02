/** A button that is an icon: its words are its label and, with its key, its title. */
import type { ComponentProps } from "react";

import { Icon } from "../theme";

interface ToolProps extends Omit<ComponentProps<"button">, "type" | "title" | "children" | "className"> {
  icon: string;
  label: string;
  keys?: string;
  testId?: string | undefined;
  /** In the head of a panel or in a row. */
  small?: boolean;
  iconSize?: number;
  /** False where what it does is plain from where it stands: a panel's x. */
  titled?: boolean;
  className?: string;
}

export function Tool({
  icon,
  label,
  keys,
  testId,
  small = false,
  iconSize = small ? 16 : 18,
  titled = true,
  className = "",
  ...rest
}: ToolProps) {
  return (
    <button
      type="button"
      className={["tool rigid", small ? "small" : "", className].filter(Boolean).join(" ")}
      aria-label={label}
      {...(titled ? { title: keys === undefined ? label : `${label} (${keys})` } : {})}
      data-testid={testId}
      data-removes={icon === "trash-2" ? "" : undefined}
      {...rest}
    >
      <Icon name={icon} size={iconSize} />
    </button>
  );
}
