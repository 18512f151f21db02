/** Runs that another window steers. */
export const WATCHING_EN = {
  "watching.leave": "Stop watching",
} as const;
