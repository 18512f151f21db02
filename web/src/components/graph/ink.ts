/** The colours of a drawing that is kept: those of the theme in use or, on paper, the light ones in every theme. */

let ground: Element | null = null;
/** Reading a style is slow, and a drawing asks for thousands. */
let drawing = false;
const known = new Map<string, string>();

/** The value of a colour for what is being drawn now. */
export function token(name: string): string {
  const found = known.get(name);
  if (found !== undefined) return found;
  const style = getComputedStyle(ground ?? document.documentElement);
  const value = style.getPropertyValue(`--${name}`).trim();
  if (drawing) known.set(name, value);
  return value;
}

/** Draws in the colours of the theme; what is drawn must be there when `draw` comes back. */
export function inTheme<T>(draw: () => T): T {
  drawing = true;
  try {
    return draw();
  } finally {
    drawing = false;
    known.clear();
  }
}

/** Draws in the colours for paper, in the same way. */
export function onPaper<T>(draw: () => T): T {
  const paper = document.createElement("div");
  paper.className = "paper";
  paper.hidden = true;
  document.body.append(paper);
  ground = paper;
  try {
    return inTheme(draw);
  } finally {
    ground = null;
    paper.remove();
  }
}
