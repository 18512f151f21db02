/** Real robots. */
export const ROBOTS_EN = {
  "menu.robots": "Robots",
  "boards.panel": "Robots panel",
  "boards.run": "Run on robot",
  "boards.stop-all": "Stop all",
  "robots.behind": "You see what the robots did at {time}. Pausing here does not pause them.",
  "robots.now": "Back to now",
  "boards.on-robot": "Running on a robot",
} as const;
