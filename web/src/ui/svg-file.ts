/** A picture of the page as a file of its own: it carries the styles that the page gives it, and the ground it stands on. */

const STYLES = [
  ...["fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "opacity"],
  ...["font-family", "font-size", "font-weight"],
];
const OF_THE_PAGE = ["class", "role", "tabindex", "data-testid", "aria-pressed", "aria-hidden"];
const CLEAR = "rgba(0, 0, 0, 0)";

function groundOf(picture: Element): string {
  for (let at: Element | null = picture; at !== null; at = at.parentElement) {
    const { backgroundColor } = getComputedStyle(at);
    if (backgroundColor !== "" && backgroundColor !== CLEAR) return backgroundColor;
  }
  return "white";
}

/** The text of an SVG file that looks like this picture does now. */
export function svgFileOf(picture: SVGSVGElement): string {
  const copy = picture.cloneNode(true) as SVGSVGElement;
  const shown = [picture, ...picture.querySelectorAll("*")];
  [copy, ...copy.querySelectorAll("*")].forEach((element, at) => {
    const styles = getComputedStyle(shown[at] ?? picture);
    for (const name of STYLES) {
      const value = styles.getPropertyValue(name);
      if (value !== "") element.setAttribute(name, value);
    }
    for (const name of OF_THE_PAGE) element.removeAttribute(name);
  });
  const ground = document.createElementNS(copy.namespaceURI ?? "http://www.w3.org/2000/svg", "rect");
  for (const [name, value] of [
    ["width", "100%"],
    ["height", "100%"],
    ["fill", groundOf(picture)],
  ] as const)
    ground.setAttribute(name, value);
  copy.prepend(ground);
  return new XMLSerializer().serializeToString(copy);
}
