/** Fonts of text on a canvas, which knows no variables of CSS: the same family as the page's own text has (`--sans`). */
import { token } from "./theme";

let family = "";
let language: string | null = null;

/** What `font` of a canvas takes, in the family of the page's language. */
export function fontOf(weight: number, px: number): string {
  const { lang } = document.documentElement;
  if (lang !== language) {
    language = lang;
    family = token("sans") || "sans-serif";
  }
  return `${String(weight)} ${px.toFixed(1)}px ${family}`;
}
