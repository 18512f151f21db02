/** English for tutorials and the welcome. */
export const TUTORIAL_EN = {
  "tutorial.title": "Tutorials",
  "tutorial.welcome": "New here?",
  "tutorial.welcome-help": "Press Run and watch this mission at work, or make a robot drive yourself in a few minutes.",
  "tutorial.not-now": "Not now",
  "tutorial.point-run": "Run",
  "tutorial.point-vertex": "{name} in the graph",
  "tutorial.point-part": "{name} in the parts",
  "tutorial.point-program": "the tab {name}",
  "tutorial.point-speed": "the speed",
  "tutorial.point-group": "the group {name}",
  "tutorial.point-file-menu": "the menu File",
} as const;
