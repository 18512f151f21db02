/** Downloads the mission's custom blocks as a constructors file. */
import { ownConstructors } from "../../model/own-parts";
import { useStudio } from "../../model/studio";
import { reportError } from "../../session/document";
import { download } from "../../ui/download";
import { partsApi } from "./server";

export async function shareParts(): Promise<void> {
  const { mission, file } = useStudio.getState();
  try {
    const { text } = await partsApi.file(ownConstructors(mission));
    const stem = (file.name || "mission").replace(/\.krt$/i, "");
    download(`${stem}.constructors.xml`, text, "application/xml");
  } catch (cause) {
    reportError(cause, () => void shareParts());
  }
}
