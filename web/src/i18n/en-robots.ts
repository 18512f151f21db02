/** Real robots. */
export const ROBOTS_EN = {
  "menu.robots": "Robots",
  "boards.panel": "Robots panel",
  "boards.run": "Run on robot",
  "boards.stop-all": "Stop all",
  "boards.file": "Save a file for the board…",
  "boards.on-robot": "Running on a robot",
} as const;
