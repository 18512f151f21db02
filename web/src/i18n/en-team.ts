/** English for the team, the world, variables, and files with parts. */
export const TEAM_EN = {
  "command.edit": "Change {name}",
  "command.world": "Change the world",
  "command.title": "Change the title",
  "command.help": "Change what happens",

  "team.tab": "Team",
  "team.no-free-start": "Every start of this world is taken, so {name} has no robot yet.",
  "team.let-run": "Let {agent} run {name}",
  "team.open": "Open the team",
  "team.goal": "goal",
  "command.place": "Put the robots on free starts",

  "roster.label": "Team and parts",
  "roster.team": "Team",
  "roster.parts": "Parts",
  "first-team.social": "Program of the whole team",
  "first-team.group": "Program of a group",

  "variable.new": "New variable",
  "variable.new-dots": "New variable…",
  "variable.menu": "Variable {name}",
  "variable.rename": "Rename",
  "variable.edit": "Change…",
  "variable.remove": "Remove",
  "variable.used": "{name} is used: {places}. Remove it all the same?",
  "variable.used-help": "The vertices stay, as parts that nobody knows. Undo brings it back.",
  "variable.used-in": { one: "{count} time in {program}", other: "{count} times in {program}" },
  "variable.show-in": "Show in {program}",
  "variable.remove-anyway": "Remove",
  "variable.keep-it": "Keep it",

  "parts.add-file": "Add parts from a file…",
  "parts.added-robot": "The robot {names} is there now.",
  "parts.added-constructors": { one: "{names} is in the palette now.", other: "{names} are in the palette now." },
  "parts.added-world": "The world {names} is there now.",
  "variable.name": "Name",
} as const;
