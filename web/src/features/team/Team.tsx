/**
 * The team in the place of the canvas: agents, goals, failures, conditions, the world.
 *
 * A chunk of its own, fetched when the tab is opened.
 */
import "./team.css";

import { useEffect, useRef } from "react";

import { languageInUse, t } from "../../i18n/words";
import { changeTitle } from "../../model/commands/changeTitle";
import { execute, useStudio } from "../../model/studio";
import { startTeam } from "../../session/first-team";
import { useShown } from "../../session/simple-view";
import { useTeam } from "../../session/team-view";
import { Button } from "../../ui/Button";
import { Field } from "../../ui/Field";
import { Agents } from "./Agents";
import { Conditions } from "./Conditions";
import { Failures } from "./Failures";
import { Goals } from "./Goals";
import { Worlds } from "./Worlds";

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

/** What a team's program is, and a first one to begin with, where the mission has none. */
function FirstTeam() {
  const there = useStudio((studio) => studio.mission.programs.some((one) => one.level === "social"));
  const shown = useShown("team");
  if (there || !shown) return null;
  return (
    <section className="team-part surface" aria-labelledby="first-team" data-testid="first-team">
      <h2 id="first-team">{t("first-team.title")}</h2>
      <p className="team-note muted">{t("first-team.what")}</p>
      <p className="row wrap">
        <Button icon="users" testId="start-team" onClick={() => void startTeam()}>
          {" "}
          {t("first-team.start")}
        </Button>
        <span>{t("first-team.start-help")}</span>
      </p>
    </section>
  );
}

/** The mission's title and what happens in it, in the language of the page; English stands in for another one. */
export function About() {
  const label = useStudio((studio) => studio.mission.label);
  const help = useStudio((studio) => studio.mission.help);
  const spoken = languageInUse();
  const language = spoken === "en" ? "" : spoken;
  const change = (what: "label" | "help", words: string) =>
    execute(changeTitle(useStudio.getState().mission, what, language, words));
  return (
    <section className="team-part surface" aria-labelledby="team-about">
      <h2 id="team-about">{t("team.about")}</h2>
      <Field label={t("team.title")}>
        <input
          className="field"
          data-testid="team-title"
          dir="auto"
          value={label?.[language] ?? ""}
          placeholder={label?.[""] ?? ""}
          onChange={(event) => change("label", event.target.value)}
        />
      </Field>
      <Field label={t("team.help")}>
        <textarea
          className="field"
          data-testid="team-help"
          dir="auto"
          rows={2}
          value={help?.[language] ?? ""}
          placeholder={help?.[""] ?? ""}
          onChange={(event) => change("help", event.target.value)}
        />
      </Field>
    </section>
  );
}
