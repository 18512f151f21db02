/** A sentence of the server: what stands between back quotes is a name and set as one. */
export function Said({ text }: { text: string }) {
  return text.split(/`([^`]*)`/).map((part, index) => (index % 2 === 1 ? <code key={index}>{part}</code> : part));
}
