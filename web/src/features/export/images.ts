/** The program in view as a file: its image as a robot runs it, the listing of that, its behaviour tree. */
import { api } from "../../api/client";
import { t } from "../../i18n/words";
import { programInView, useStudio } from "../../model/studio";
import type { Mission } from "../../model/types";
import { question, reportError } from "../../session/document";
import { walkProblems } from "../../session/problem-walk";
import { download } from "../../ui/download";

/** Compiles it anew, so that what is kept is what is drawn; says it when there are errors. */
async function make<Made>(
  request: (mission: Mission, path: string, program: string) => Promise<Made>,
  keep: (name: string, made: Made) => void,
): Promise<void> {
  const state = useStudio.getState();
  const program = programInView(state);
  if (program === undefined) return;
  const { name } = program;
  const { report, mission, file } = state;
  if (report?.problems.some((problem) => problem.severity === "error" && problem.program === name)) {
    const show = () => {
      walkProblems(1);
    };
    question(t("out.no-image", { name }), [["out.show-problem", show]], "error", t("out.no-image-help"));
    return;
  }
  try {
    keep(name, await request(mission, file.path, name));
  } catch (cause) {
    reportError(cause);
  }
}

export function downloadImage(): Promise<void> {
  return make(api.image, (name, { image }) => {
    const bytes = Uint8Array.from(atob(image), (letter) => letter.charCodeAt(0));
    download(`${name}.kri`, bytes, "application/octet-stream");
  });
}

export function downloadListing(): Promise<void> {
  return make(api.image, (name, { listing }) => {
    download(`${name}.kra`, listing, "text/plain");
  });
}

export function downloadTree(): Promise<void> {
  return make(api.tree, (name, tree) => {
    download(`${name}.xml`, tree, "application/xml");
  });
}
