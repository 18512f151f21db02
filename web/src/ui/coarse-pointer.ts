/** Whether fingers point at the page, not a mouse: words say "tap" then. */
export function hasCoarsePointer(): boolean {
  return matchMedia("(pointer: coarse)").matches;
}
