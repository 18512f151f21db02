/**
 * What runs in the program in view: which agent is watched, where there are several, and a token per live thread that leads to
 * its vertex. Tokens without room are a list behind their number.
 */
import { useShallow } from "zustand/react/shallow";

import { t } from "../../i18n/words";
import { programInView, useStudio } from "../../model/studio";
import { reveal } from "../../session/actions";
import { complain } from "../../session/document";
import { useActiveVertices, useRun, watchedAgent } from "../../session/run";
import { useShown } from "../../session/simple-view";
import { later } from "../../ui/later";
import type { Thread } from "./RunningRow";

const Row = later(() => import("./RunningRow").then((chunk) => chunk.RunningRow), complain);

function useThreads(program: string): Thread[] {
  const active = useActiveVertices(program);
  const vertices = useStudio((studio) => programInView(studio)?.vertices);
  return [...active]
    .flatMap(([vertex, slots]) => slots.map((slot) => ({ slot, vertex })))
    .sort((a, b) => a.slot - b.slot)
    .map(({ slot, vertex }) => ({
      slot,
      label: t("tabs.thread", { slot, vertex: vertices?.find((one) => one.id === vertex)?.element ?? vertex }),
      go: () => reveal(program, [vertex]),
    }));
}

export function Running({ program }: { program: string }) {
  const all = useThreads(program);
  const threads = useShown("threads") ? all : [];
  const chosen = useRun((run) => watchedAgent(run, program)?.name ?? "");
  // The names stay while what the agents do changes: there may be thousands.
  const names = useRun(
    useShallow((run) => run.agents.filter((agent) => agent.program === program).map((agent) => agent.name)),
  );
  if (threads.length === 0 && names.length < 2) return null;
  return <Row threads={threads} names={names} chosen={chosen} />;
}
