/** English for what a robot is built of, which is fetched later. */
export const KITS_EN = {
  "parts.added-board": "The kit {names} is there now.",
  "boards.kit": "Built of",
  "boards.kit-own": "What its own file says",
} as const;
