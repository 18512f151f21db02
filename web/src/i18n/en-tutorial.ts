/** English for tutorials and the welcome. */
export const TUTORIAL_EN = {
  "tutorial.title": "Tutorials",
  "tutorial.welcome": "New here?",
  "tutorial.welcome-help": "In a few minutes you make a robot drive.",
  "learn.open": "Learn step by step",
  "tutorial.not-now": "Not now",
} as const;
