/** Runs that another window steers. */
export const WATCHING_EN = {
  "watching.offer": "A run of this mission is going on in another window.",
  "watching.watch": "Watch it",
  "watching.on": "You are watching a run that another window steers; STOP here only ends the watching.",
  "watching.another": "What runs there is not what is open here: its parts may not glow where they stand.",
  "watching.leave": "Stop watching",
} as const;
