/** Icons by name, as `build/lucide.ts` gives them: each a few SVG elements in a square of 24. */
declare module "*.lucide" {
  const icons: Readonly<
    Record<string, readonly (readonly [tag: string, attributes: Readonly<Record<string, string>>])[]>
  >;
  export default icons;
}
