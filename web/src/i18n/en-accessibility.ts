/** English for the outline, the announcements and the help for a part. */
export const ACCESSIBILITY_EN = {
  "reach.undone": "Undone: {what}",
  "reach.redone": "Done again: {what}",
  "reach.selected": "Selected: {what}",

  "outline.title": "Outline",

  "part-help.condition": "A condition goes here.",
  "part-help.value": "A value goes here.",
  "part-help.action": "An action of the robot goes here.",

  "help.part": "Help for the selected part",

  "program.next": "Next program",
  "program.previous": "Previous program",
  "program.later": "Move the tab forward",
  "program.earlier": "Move the tab back",
} as const;
