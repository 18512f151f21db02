/** Programs as text that a person drops or chooses, LLL or a behaviour tree: each becomes a program of the mission in view. */
import { api, ApiError } from "../../api/client";
import { sentence, t } from "../../i18n/words";
import { emptyProgram } from "../../model/commands/changePrograms";
import { freeName } from "../../model/free-name";
import { robotKinds } from "../../model/robot-kinds";
import { programInView, useStudio } from "../../model/studio";
import type { Program } from "../../model/types";
import { addProgramWithAgent } from "../../session/actions";
import { note, reportError } from "../../session/document";

const TREE = /^[^<]*(?:<[?!][^>]*>[^<]*)*<root[\s>]/;
const NAME = /^\p{L}[\p{L}\p{N}_-]*$/u;

/** Whether a file is a program as text, by its name and its beginning. */
export function isProgramText(name: string, beginning: string): boolean {
  return /\.lll$/i.test(name) || (/\.xml$/i.test(name) && TREE.test(beginning));
}

/** The robot of the program in view; of a team's program, that of the first program of a robot. */
function robotInView(): string {
  const state = useStudio.getState();
  const programs = [programInView(state), ...state.mission.programs];
  return programs.find((program) => program !== undefined && program.robot !== "")?.robot ?? "";
}

function nameFor(file: string): string {
  const taken = useStudio.getState().mission.programs.map((program) => program.name);
  const stem = file.replace(/\.[^.]*$/, "").trim();
  if (!NAME.test(stem)) return freeName("program", taken);
  return taken.includes(stem) ? freeName(stem, taken) : stem;
}

/** Adds the program of a file; what is no program is said with the line of its first mistake, and changes nothing. */
export async function takeProgramText(file: File): Promise<void> {
  const robot = robotInView();
  try {
    const text = await file.text();
    const { file: open, mission } = useStudio.getState();
    const { program, problems } = await api.fragment(text, robot, open.path, mission);
    if (program === null) throw refusal(file.name, problems);
    addDrawn(file.name, robot, program);
  } catch (cause) {
    reportError(cause);
  }
}

function refusal(file: string, problems: readonly { message: string; help: string; line: number }[]): ApiError {
  const [first] = problems;
  const why = first === undefined ? "" : sentence(first.message);
  const line = first === undefined ? 1 : Math.max(1, first.line);
  const help = first === undefined || first.help === "" ? [] : [`${sentence(first.help)}.`];
  const more = problems.length > 1 ? [t("program-text.more", { count: problems.length - 1 })] : [];
  return new ApiError(t("program-text.refused", { file, line, why }), [...help, ...more].join(" "));
}

function addDrawn(file: string, robot: string, drawn: Program): void {
  const name = nameFor(file);
  const added = addProgramWithAgent({ ...emptyProgram(name, robot), vertices: drawn.vertices, arcs: drawn.arcs });
  if (!added) return;
  const label = robotKinds(useStudio.getState().catalogue.robots).find((one) => one.name === robot)?.label ?? robot;
  note(t("program-text.added", { file, name, robot: label }));
}
