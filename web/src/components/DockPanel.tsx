/** A panel below the graph: a head with its title, what else stands there, and the way to close it. */
import type { ReactNode } from "react";

import { closeDock } from "../session/dock";
import { Tool } from "../ui/Tool";

interface DockPanelProps {
  /** Its name in `session/dock`, the element's id, and its class. */
  id: string;
  testId: string;
  title: string;
  close: string;
  /** Behind the title. */
  tools?: ReactNode;
  children: ReactNode;
}

export function DockPanel({ id, testId, title, close, tools, children }: DockPanelProps) {
  return (
    <section className={`dock-panel column rigid ${id}`} id={id} data-testid={testId} aria-label={title}>
      <DockHead title={title} close={close} tools={tools} />
      {children}
    </section>
  );
}

export function DockHead({ title, close, tools }: Pick<DockPanelProps, "title" | "close" | "tools">) {
  return (
    <header className="rigid between aligned panel-head">
      <h2 className="panel-title">{title}</h2>
      {tools}
      <Tool small icon="x" label={close} titled={false} onClick={closeDock} />
    </header>
  );
}
