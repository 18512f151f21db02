/** The files of Python are fetched while a pupil types code and name: the browser has them when the studio asks for them. */
import { inPage } from "../../api/line";
import { siteParts } from "../../api/site-parts";

export function fetchAhead(): void {
  if (inPage()) void fetchFiles().catch(() => undefined);
}

async function fetchFiles(): Promise<void> {
  const { files } = await siteParts();
  await Promise.all(Object.keys(files).map(async (name) => (await fetch(name)).arrayBuffer()));
}
