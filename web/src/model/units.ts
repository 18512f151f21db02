/** Characters as the server counts them (whole ones) and as the page does (UTF-16 units). */
export const PAIRS = /[\ud800-\udbff][\udc00-\udfff]/g;

/** From whole characters to units, for one text. */
export function unitsOf(text: string): (characters: number) => number {
  const pairs: number[] = [];
  for (const match of text.matchAll(PAIRS)) pairs.push(match.index - pairs.length);
  if (pairs.length === 0) return (characters) => characters;
  return (characters) => characters + pairs.filter((at) => at < characters).length;
}
