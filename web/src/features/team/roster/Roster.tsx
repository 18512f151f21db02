/**
 * What the team is: its roles, groups and work, in the place of the parts. Robots are put into them by dragging, or from
 * the menu of their chip. A chunk of its own, fetched when it is first shown.
 */
import { type ReactNode, useEffect, useRef } from "react";

import { t } from "../../../i18n/words";
import { groupsOf, rolesOf, worksOf } from "../../../model/commands/changeDeclared";
import { useStudio } from "../../../model/studio";
import { Tool } from "../../../ui/Tool";
import { DragGhost } from "./Chip";
import { addedGroup, Groups } from "./Groups";
import { forgetSaid, usePut } from "./roster-moves";
import { addedRole, Roles, Spare } from "./Roles";
import { addedWork, Works } from "./Works";
import "./roster.css";

interface SectionProps {
  what: "role" | "group" | "work";
  title: string;
  none: string;
  empty: boolean;
  /** Adds one and gives its name; null where it cannot be. */
  add: () => string | null;
  can: boolean;
  children: ReactNode;
}

function Section({ what, title, none, empty, add, can, children }: SectionProps) {
  const list = useRef<HTMLUListElement>(null);
  const added = () => {
    const name = add();
    if (name === null) return;
    // What is new is named first.
    requestAnimationFrame(() => {
      const card = list.current?.querySelector<HTMLElement>(`[data-testid="card-${CSS.escape(name)}"]`);
      card?.querySelector<HTMLElement>('[aria-expanded="false"].tool')?.click();
      requestAnimationFrame(() => {
        const field = card?.querySelector<HTMLInputElement>(".roster-card-name input");
        field?.focus();
        field?.select();
        card?.scrollIntoView({ block: "nearest" });
      });
    });
  };
  return (
    <section aria-labelledby={`roster-${what}`} className="roster-part">
      <header>
        <h2 id={`roster-${what}`}>{title}</h2>
        <Tool
          small
          icon="plus"
          label={t(`roster.add-${what}`)}
          testId={`add-${what}`}
          aria-disabled={!can}
          onClick={() => {
            if (can) added();
          }}
        />
      </header>
      {empty ? <p className="muted small-text below">{none}</p> : null}
      <ul className="column" ref={list}>
        {children}
      </ul>
    </section>
  );
}

/** What was said of a change goes with the next one that is not made here. */
function useSaid(): string {
  const said = usePut((put) => put.said);
  useEffect(() => {
    if (said === "") return;
    return useStudio.subscribe((state, before) => {
      if (state.mission !== before.mission) forgetSaid();
    });
  }, [said]);
  return said;
}

export default function Roster() {
  const mission = useStudio((studio) => studio.mission);
  const roles = rolesOf(mission).length;
  const said = useSaid();
  return (
    <div className="roster column gap-xl" data-testid="roster">
      <Section
        what="role"
        title={t("roster.roles")}
        none={t("roster.roles-none")}
        empty={roles === 0}
        add={addedRole}
        can
      >
        <Roles />
      </Section>
      <Spare />
      <Section
        what="group"
        title={t("roster.groups")}
        none={t("roster.groups-none")}
        empty={groupsOf(mission).length === 0}
        add={addedGroup}
        can={roles > 0 || mission.agents.length > 0}
      >
        <Groups />
      </Section>
      <Section
        what="work"
        title={t("roster.work")}
        none={t("roster.work-none")}
        empty={worksOf(mission).length === 0}
        add={addedWork}
        can
      >
        <Works />
      </Section>
      <p className="roster-said small-text ink" role="status" data-testid="roster-said">
        {said}
      </p>
      <DragGhost />
    </div>
  );
}
