/** The open mission and a program of it as files for the person to keep. */
import { api } from "../api/client";
import { useStudio } from "../model/studio";
import { complain, fileName } from "../session/document";
import { download } from "../ui/download";

export async function downloadMission(): Promise<void> {
  try {
    const { text } = await api.missionText(useStudio.getState().mission);
    download(fileName(), text, "application/xml");
  } catch (cause) {
    complain(cause);
  }
}

export function downloadProgram(): void {
  const { activeProgram, report } = useStudio.getState();
  const found = report?.programs.find((program) => program.name === activeProgram);
  if (found !== undefined) download(`${activeProgram}.lll`, found.lll, "text/plain");
}
