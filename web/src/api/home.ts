/** Where the files of a static site are in the browser's storage: of each path, and in a class of each pupil, its own. */
export function homeOf(base: string, pupil: string): string {
  const home = `/home/${encodeURIComponent(new URL(base).pathname)}`;
  return pupil === "" ? home : `${home} ${pupil}`;
}
