/** The tree of parts that a program is made of. */
export function Palette() {
  return <div className="palette" />;
}
