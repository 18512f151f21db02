/**
 * Words and icons of a drawing, at the places that the layout counted with.
 *
 * Letters are squeezed or stretched to the width that the layout counted with, so that nothing leaves its box where
 * Inter is not installed. Where the page runs from right to left, so does what stands in a vertex, as on the canvas.
 */
import { mirrored } from "../../i18n/language";
import { textWidth } from "../../model/measure";
import { Icon } from "../../theme";
import { token } from "./ink";

/** The font whose widths the layout has measured. */
const KNOWN = /^[\x20-\x7e]*$/;
/** Letters of scripts that run from right to left, and lines that begin with one. */
export const RIGHT_TO_LEFT = /[\u0590-\u08ff\ufb1d-\ufdff\ufe70-\ufefc]/;
const BEGINS_RIGHT_TO_LEFT = /^\P{L}*[\u0590-\u08ff\ufb1d-\ufdff\ufe70-\ufefc]/u;

interface TextProps {
  /** The left side of the room that the layout gave it. */
  x: number;
  y: number;
  size: number;
  bold?: boolean;
  colour: string;
  children: string;
}

export function Text({ x, y, size, bold = false, colour, children }: TextProps) {
  const width = textWidth(children, size, bold);
  const runsLeft = RIGHT_TO_LEFT.test(children) && (mirrored() || BEGINS_RIGHT_TO_LEFT.test(children));
  return (
    <text
      x={mirrored() ? x + width : x}
      y={y + size * 0.36}
      fontSize={size}
      fontWeight={bold ? 600 : 400}
      direction={runsLeft ? "rtl" : "ltr"}
      textAnchor={runsLeft === mirrored() ? "start" : "end"}
      fill={token(colour)}
      {...(KNOWN.test(children) && width > 0 ? { textLength: width, lengthAdjust: "spacingAndGlyphs" } : {})}
    >
      {children}
    </text>
  );
}

/** Places inside of what reaches from `x` over `w`, turned around where the page is. */
export function turned(x: number, w: number) {
  const rtl = mirrored();
  return {
    /** The left side of something that is `width` wide and would begin at `left`. */
    box: (left: number, width: number) => (rtl ? 2 * x + w - left - width : left),
    /** The same for a line of text. */
    text: (left: number, words: string, size: number, bold = false) => {
      return rtl ? 2 * x + w - left - textWidth(words, size, bold) : left;
    },
  };
}

/** The words, shortened until they fit into a room of this width in px. */
export function fitting(words: string, room: number, size: number, bold = false): string {
  while (words.length > 1 && textWidth(words, size, bold) > room) words = `${words.slice(0, -2)}…`;
  return words;
}

/** Where things of these widths begin, one after the other. */
export function places(start: number, widths: readonly number[], gap: number): number[] {
  return widths.map((_, index) => widths.slice(0, index).reduce((sum, width) => sum + width + gap, start));
}

export function Sign({
  name,
  x,
  y,
  size,
  colour,
}: {
  name: string;
  x: number;
  y: number;
  size: number;
  colour: string;
}) {
  return (
    <g transform={`translate(${String(x)} ${String(y - size / 2)})`} color={token(colour)}>
      <Icon name={name} size={size} />
    </g>
  );
}
