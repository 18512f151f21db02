/** The arena's colours as they stand in the theme. */
import { token } from "../../theme";

const NAMES = {
  ground: "arena-ground",
  tile: "arena-tile",
  grid: "arena-grid",
  road: "arena-road",
  kerb: "arena-kerb",
  mark: "arena-mark",
  red: "arena-red",
  green: "arena-green",
  blue: "arena-blue",
  bay: "arena-bay",
  bayLine: "arena-bay-line",
  house: "arena-house",
  slot: "arena-slot",
  box: "arena-box",
  boxLine: "arena-box-line",
  ball: "arena-ball",
  ballLight: "arena-ball-light",
  ballLine: "arena-ball-line",
  robot: "arena-robot",
  bed: "arena-robot-bed",
  robotLine: "arena-robot-line",
  wheel: "arena-wheel",
  shade: "arena-shade",
  line2: "line2",
  text: "text",
  muted: "muted",
  ink: "ink",
  onInk: "on-ink",
  panel: "panel",
  glow: "arena-glow",
} as const;

export type Colours = Record<keyof typeof NAMES, string>;

export function readColours(): Colours {
  return Object.fromEntries(Object.entries(NAMES).map(([name, variable]) => [name, token(variable)])) as Colours;
}
