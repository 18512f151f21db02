/** A button of the bottom bar, which opens and closes a panel below the graph. */
import type { ReactNode } from "react";

import { toggleDock, useDock } from "../session/dock";
import { Icon } from "../theme";
import "../ui/dock.css";

interface DockButtonProps {
  icon: string;
  testId: string;
  /** Its name in `session/dock`, and the element's id. */
  panel: string;
  title?: string;
  busy?: boolean;
  children: ReactNode;
}

export function DockButton({ icon, testId, panel, title, busy, children }: DockButtonProps) {
  const open = useDock((dock) => dock.open === panel);
  return (
    <button
      type="button"
      className="dock-button inline-row medium hover"
      data-testid={testId}
      aria-expanded={open}
      aria-controls={panel}
      aria-busy={busy}
      title={title}
      onClick={() => toggleDock(panel)}
    >
      <Icon name={icon} size={16} />
      {children}
    </button>
  );
}
