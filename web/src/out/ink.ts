/** The colours of a drawing that is kept: those of the theme in use or, on paper, the light ones in every theme. */

let ground: Element | null = null;
const known = new Map<string, string>();

/** The value of a colour for what is being drawn now. */
export function token(name: string): string {
  const found = ground === null ? undefined : known.get(name);
  if (found !== undefined) return found;
  const style = getComputedStyle(ground ?? document.documentElement);
  const value = style.getPropertyValue(`--${name}`).trim();
  if (ground !== null) known.set(name, value);
  return value;
}

/** Draws for paper; what is drawn must be there when `draw` comes back. */
export function onPaper<T>(draw: () => T): T {
  const paper = document.createElement("div");
  paper.className = "paper";
  paper.hidden = true;
  document.body.append(paper);
  ground = paper;
  try {
    return draw();
  } finally {
    ground = null;
    known.clear();
    paper.remove();
  }
}
