/** English for tutorials and the welcome. */
export const TUTORIAL_EN = {
  "tutorial.title": "Tutorials",
  "tutorial.welcome": "New here?",
  "tutorial.welcome-help": "Press Run and watch this mission at work, or make a robot drive yourself in a few minutes.",
  "learn.open": "Learn step by step",
  "tutorial.not-now": "Not now",
} as const;
