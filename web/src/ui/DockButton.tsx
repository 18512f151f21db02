/** A button of the bottom bar, which opens and closes a panel above. */
import type { ReactNode } from "react";

import { Icon } from "../theme";

import "./dock.css";

interface DockButtonProps {
  icon: string;
  testId: string;
  open: boolean;
  /** The id of the panel. */
  panel: string;
  onPress: () => void;
  title?: string;
  busy?: boolean;
  children: ReactNode;
}

export function DockButton({ icon, testId, open, panel, onPress, title, busy, children }: DockButtonProps) {
  return (
    <button
      type="button"
      className="dock-button"
      data-testid={testId}
      aria-expanded={open}
      aria-controls={panel}
      aria-busy={busy}
      title={title}
      onClick={onPress}
    >
      <Icon name={icon} size={16} />
      {children}
    </button>
  );
}
