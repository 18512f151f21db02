/** English for what a robot is built of and for trying its parts, which is fetched later. */
export const KITS_EN = {
  "parts.added-board": "The kit {names} is there now.",
  "boards.kit": "Built of",
  "boards.kit-own": "What its own file says",
  "boards.try": "Try the parts",
  "boards.try-help": "Tries each part by hand. It takes the place of the program that the robot has.",
  "boards.try-wheels": "Lift the wheels off the ground first.",
  "boards.try-begin": "Try {part}",
  "boards.try-end": "Stop {part}",
  "boards.try-trouble": "Nothing happens?",
  "boards.try-left-out": "Not on this robot: {part}",
  "boards.try-done": "Done",
  "boards.firmware": "MicroPython for this board, from its maker",
} as const;
