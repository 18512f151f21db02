/**
 * Stands in for `d3-color`, which comes with React Flow's zoom. Its transitions move the viewport only: no colour is ever
 * animated, and none of these is called.
 */
export function color(): null {
  return null;
}

export { color as cubehelix, color as hcl, color as hsl, color as lab, color as rgb };
