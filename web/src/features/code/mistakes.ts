/**
 * Mistakes of typed texts among the problems of the mission: in the list, and on the vertices around them.
 *
 * The checker speaks of the graph, which shows the last text without mistakes; what is wrong with the text stands beside that
 * for as long as the text is wrong. The report in the studio is then the checker's with these added.
 */
import { useStudio } from "../../model/studio";
import type { Problem, Report } from "../../model/types";
import { useTyping } from "../../session/typing";
import { endAll } from "../../ui/effects";

const added = new WeakMap<Report, Report>();

function same(a: Problem, b: Problem): boolean {
  return a.code === b.code && a.message === b.message && a.program === b.program;
}

/** The report with the problems that are not in it already. */
export function withMistakes(report: Report, mistakes: readonly Problem[]): Report {
  const news = mistakes.filter((one) => !report.problems.some((told) => same(told, one)));
  if (news.length === 0) return report;
  const made = { ...report, problems: [...report.problems, ...news] };
  added.set(made, report);
  return made;
}

function mistakesNow(): Problem[] {
  const drafts = Object.values(useTyping.getState().drafts);
  return drafts.flatMap((draft) => (draft.right ? [] : draft.problems.filter((one) => one.severity === "error")));
}

/** Keeps them there; the returned function ends that. */
export function showMistakes(): () => void {
  const settle = () => {
    const { report, setReport } = useStudio.getState();
    if (report === null) return;
    const plain = added.get(report) ?? report;
    const mistakes = mistakesNow();
    const wanted = withMistakes(plain, mistakes);
    const shown = report.problems;
    const settled = wanted.problems.length === shown.length && wanted.problems.every((one, at) => one === shown[at]);
    if (!settled) setReport(wanted);
  };
  const offTyping = useTyping.subscribe(settle);
  const offReport = useStudio.subscribe((state, before) => {
    if (state.report !== before.report) settle();
  });
  return endAll(offTyping, offReport);
}
