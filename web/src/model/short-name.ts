/** The number at the end of a robot's name, else the name. */
export function shortName(name: string): string {
  return /\d+$/.exec(name)?.[0] ?? name;
}
