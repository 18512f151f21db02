/** English for the outline, the announcements and the help for a part. */
export const ACCESSIBILITY_EN = {
  "reach.undone": "Undone: {what}",
  "reach.redone": "Done again: {what}",
  "reach.selected": "Selected: {what}",

  "outline.title": "Outline",
  "outline.of": "Outline of {name}",
  "outline.close": "Close the outline",

  "part-help.title": "Help for a part",
  "part-help.how": "Select a part in the graph or in the list of parts, then press F1.",
  "part-help.range": "A whole number from {min} to {max}, at first {first}",
  "part-help.switch": "True or false",
  "part-help.text": "A text",
  "part-help.condition": "A test goes here.",
  "part-help.value": "A value goes here.",
  "part-help.action": "An action of the robot goes here.",
  "part-help.body": "Other parts go inside.",

  "help.part": "Help for the selected part",

  "program.next": "Next program",
  "program.previous": "Previous program",
  "program.later": "Move the tab forward",
  "program.earlier": "Move the tab back",
} as const;
