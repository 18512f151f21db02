/** What a static site is made of, as its `site.json` says. */
export interface Parts {
  /** Changes with every byte of the files below. */
  version: string;
  pyodide: string;
  packages: string;
  /** Compiled libraries: their names among the packages, and the files that hold them. */
  libraries: Record<string, string>;
  /** Languages with sentences of their own: the file among the packages that holds them. */
  words: Record<string, string>;
  /** Where packages belong in Pyodide. */
  place: string;
  /** Files that Python needs, with their sizes as they travel. */
  files: Record<string, number>;
  /** Files of the page. */
  page: string[];
}

export const PARTS = "site.json";

let asked: Promise<Parts> | null = null;

/** Asked for once; after a failure once more. */
export function siteParts(): Promise<Parts> {
  asked ??= fetchParts().catch((cause: unknown) => {
    asked = null;
    throw cause;
  });
  return asked;
}

async function fetchParts(): Promise<Parts> {
  const said = await fetch(new URL(PARTS, document.baseURI));
  if (!said.ok) throw new Error(PARTS);
  return (await said.json()) as Parts;
}
