/**
 * A sentence of the server: what stands between back quotes is a name and set as one.
 *
 * Messages begin small because a terminal prints them after a place; a page begins its sentences large.
 */
export function Said({ text }: { text: string }) {
  const sentence = text.charAt(0).toUpperCase() + text.slice(1);
  return sentence.split(/`([^`]*)`/).map((part, index) => (index % 2 === 1 ? <code key={index}>{part}</code> : part));
}
