/** Colours of robots: of the body, and of lines on the floor in light and dark (trails, numbers, pens). */

export interface Lid {
  fill: string;
  light: string;
  dark: string;
}

const lid = (fill: string, light: string, dark: string): Lid => ({ fill, light, dark });

/** Robots take them in this order; arms are `SUN`, who sits in a storehouse `STONE`. */
export const LIDS: readonly Lid[] = [
  lid("#f7a154", "#c8560a", "#f2914a"),
  lid("#66c9c2", "#0a7f7f", "#30b9b4"),
  lid("#bba2f3", "#7549cc", "#a787f0"),
  lid("#86b7f7", "#1d6ad4", "#5ca2f8"),
  lid("#f2a2cb", "#bf2f7e", "#f06bb0"),
  lid("#86d09d", "#1c8548", "#43bc74"),
  lid("#f7d15c", "#946500", "#e5b93f"),
  lid("#c6ccd6", "#5b6472", "#9ba5b4"),
];

/** So many are for robots that drive. */
export const DRIVING = 6;
export const SUN = 6;
export const STONE = 7;
