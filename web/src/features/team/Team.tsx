/**
 * The team in the place of the canvas: agents, goals, failures, conditions, the world.
 *
 * A chunk of its own, fetched when the tab is opened.
 */
import { useEffect, useRef } from "react";

import { t } from "../../i18n/words";
import { useTeam } from "../../session/team-view";
import { About } from "./About";
import { Agents } from "./Agents";
import { Conditions } from "./Conditions";
import { Failures } from "./Failures";
import { FirstTeam } from "./FirstTeam";
import { Goals } from "./Goals";
import { Worlds } from "./Worlds";
import "./team.css";

const FIRST = { agent: "agent-start", goal: "goal-house", failure: "failure-agent", world: "" } as const;

export default function Team() {
  const wanted = useTeam((team) => team.wanted);
  const root = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (wanted === null) return;
    const { what, at } = wanted;
    const field = what === "world" ? ".team-worlds input" : `[data-testid="${FIRST[what]}-${String(at)}"]`;
    const found = root.current?.querySelector<HTMLElement>(field);
    found?.scrollIntoView({ block: "center" });
    found?.focus();
  }, [wanted]);
  return (
    <div
      className="team cover scroll"
      id="team-panel"
      role="tabpanel"
      aria-label={t("team.tab")}
      data-testid="team"
      ref={root}
    >
      <div className="team-body column gap-2xl">
        <Agents />
        <FirstTeam />
        <Goals />
        <Failures />
        <Conditions />
        <Worlds />
        <About />
      </div>
    </div>
  );
}
