/** What a team's text can be completed with besides parts: its names, and the words of its declarations. */
import { type Completion, snippetCompletion } from "@codemirror/autocomplete";

import { t } from "../../i18n/words";
import { inSet } from "../../model/team-names";
import { TEAM_ROBOT } from "../../model/team-robot";
import type { Mission, Robot } from "../../model/types";
import type { Place } from "./standing";

/** Names that a team's text can speak of, each with what is said beside it. */
export interface TeamNames {
  roles: readonly Named[];
  groups: readonly Named[];
  agents: readonly Named[];
  /** Those that may stand in this one by `PROGRAM`. */
  programs: readonly Named[];
  robots: readonly Named[];
}

interface Named {
  name: string;
  detail: string;
}

const LEVELS = ["agent", "group", "social"];

/** The names that the text of a program can speak of; `robots`: the kinds of robots at hand. */
export function teamNames(mission: Mission, robots: readonly Robot[], program: string): TeamNames {
  const own = LEVELS.indexOf(mission.programs.find((one) => one.name === program)?.level ?? "agent");
  const kind = (name: string) => mission.programs.find((one) => one.name === name)?.robot ?? "";
  return {
    roles: (mission.roles ?? []).map(({ name, robot }) => ({ name, detail: robot })),
    groups: (mission.groups ?? []).map(({ name, members }) => ({ name, detail: members.map(inSet).join(", ") })),
    agents: mission.agents.map((agent) => ({ name: agent.name, detail: agent.robot ?? kind(agent.program) })),
    programs: mission.programs
      .filter((one) => one.name !== program && LEVELS.indexOf(one.level ?? "agent") <= own)
      .map(({ name, robot }) => ({ name, detail: robot })),
    robots: robots.filter(({ name }) => name !== TEAM_ROBOT).map(({ name }) => ({ name, detail: "" })),
  };
}

/** The words of declarations, each with fields for what it says. */
export function declarationOptions(): Completion[] {
  const made = (label: string, form: string, snippet: string, info: string) =>
    snippetCompletion(snippet, { label, detail: form, info, type: "declaration", boost: 20 });
  return [
    made("role", "role name: robot 1..3;", "role ${name}: ${robot} ${1};", t("completion.role")),
    made(
      "group",
      "group name = {members} on failure drop;",
      "group ${name} = {${members}} on failure ${drop};",
      t("completion.group"),
    ),
    made("work", "work name = 10 lease 60;", "work ${name} = ${10};", t("completion.work")),
  ];
}

/** The names and words that may stand at a place of a team's text. */
export function nameOptions({ standing, declared, within }: Place, names: TeamNames): Completion[] {
  const groups = () => [...named("role", names.roles), ...named("group", names.groups), ...written(declared, names)];
  switch (standing) {
    case "members":
      return firstOfEach([...groups(), ...named("agent", names.agents)]).filter(({ label }) => label !== within);
    case "group":
      return groups();
    case "program":
      return named("program", names.programs);
    case "robot":
      return named("robot", names.robots);
    case "on":
      return [{ label: "on failure", apply: "on failure ", type: "declaration", info: t("roster.failure") }];
    case "failure":
      return [
        { label: "drop", type: "declaration", detail: t("roster.drop-policy") },
        { label: "substitute", type: "declaration", detail: t("roster.substitute-policy") },
        { label: "abort", type: "declaration", detail: t("roster.abort-policy") },
      ];
    case "lease":
      return [{ label: "lease", apply: "lease ", type: "declaration", info: t("roster.lease-help") }];
    default:
      return [];
  }
}

function named(type: string, names: readonly Named[]): Completion[] {
  return names.map(({ name, detail }) => ({ label: inSet(name), detail, type }));
}

/** Roles and groups that only the text declares so far. */
function written(declared: readonly string[], { roles, groups }: TeamNames): Completion[] {
  const known = new Set([...roles, ...groups].map(({ name }) => inSet(name)));
  return [...new Set(declared)].filter((one) => !known.has(one)).map((label) => ({ label, type: "group" }));
}

/** A role or a group that has the name of an agent counts before it. */
function firstOfEach(options: Completion[]): Completion[] {
  return options.filter(({ label }, at) => options.findIndex((one) => one.label === label) === at);
}
