/**
 * The speed slider's scale: positions 0…100 are 0.1× … 100×, a decade every 33⅓; past its end is "as fast as it goes" (0).
 */
export const MAX_POSITION = 108;
const TOP = 100;
const ROUND = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];

/** Rounded to two leading digits, as a person would say it. */
function tidy(speed: number): number {
  const digits = Math.floor(Math.log10(speed)) - 1;
  const unit = 10 ** digits;
  const rounded = Math.round(speed / unit) * unit;
  return Number(rounded.toPrecision(2));
}

export function speedAt(position: number): number {
  if (position > TOP + 2) return 0;
  const decades = (Math.min(Math.max(position, 0), TOP) / TOP) * 3 - 1;
  // Every round speed has the place nearest to it, so that it can be set by dragging.
  const round = ROUND.find((speed) => Math.abs(Math.log10(speed) - decades) <= 3 / TOP / 2);
  return round ?? tidy(10 ** decades);
}

export function positionOf(speed: number): number {
  if (speed === 0) return MAX_POSITION;
  return Math.round(((Math.log10(speed) + 1) / 3) * TOP);
}
