/** Breakpoints and the watch. */
export const DEBUG_EN = {
  "debug.breakpoint": "Pause here",
  "debug.breakpoint-off": "Pause here, off",
  "debug.toggle": "Pause here, or not",
  "debug.says-when": "when {when}",
  "debug.says-hits": "from visit {hits} on",
  "debug.paused-at": "Paused: {agent} is here, visit {visit}",
  "debug.watch": "Watch",
} as const;
