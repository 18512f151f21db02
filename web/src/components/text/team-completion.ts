/** What a team's text can be completed with besides parts: its names, and the words of its declarations. */
import { type Completion, snippetCompletion } from "@codemirror/autocomplete";

import { t } from "../../i18n/words";
import { inSet } from "../../model/team-names";
import type { Named, TeamNames } from "./team-names";
import type { Place } from "./completion-place";

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
