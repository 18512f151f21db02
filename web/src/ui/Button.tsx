/** A button with words, and an icon before them where it has one. What it does most likely next is in ink. */
import type { ComponentProps } from "react";

import { Icon } from "../theme";

interface ButtonProps extends ComponentProps<"button"> {
  icon?: string;
  iconSize?: number;
  ink?: boolean;
  testId?: string | undefined;
}

export function Button({ icon, iconSize = 16, ink, testId, className, children, ...rest }: ButtonProps) {
  const classes = ["button", ink === true ? "button-ink" : "", className ?? ""].filter(Boolean).join(" ");
  return (
    <button type="button" className={classes} data-testid={testId} {...rest}>
      {icon === undefined ? null : <Icon name={icon} size={iconSize} />}
      {children}
    </button>
  );
}
