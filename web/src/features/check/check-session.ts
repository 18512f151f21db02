/**
 * The check of this page: asked of the server over a socket of its own, and the answers as they come.
 *
 * Answers keep the mission that they are of, so that a run that is played is the one that it says, whatever was edited
 * since. They go when another mission is opened; closing the panel keeps them, and lets a check go on.
 */
import { create } from "zustand";

import type {
  CheckedProperty,
  ConfirmingRun,
  VerifyColumnMessage,
  VerifyEndMessage,
  VerifyProgressMessage,
  VerifyStartRequest,
  WorkRefusedMessage,
} from "../../api/generated";
import type { WhyRefused } from "../../api/refusal";
import { beginWork, type Work } from "../../api/work";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { isHeldByRobots, playConfirming } from "../../session/confirming-run";
import { useRun } from "../../session/run";
import type { Kinds } from "./kinds";
import { type Assumption, type Cell, columnAt, plan, sameAssumption } from "./table";

type Message = VerifyProgressMessage | VerifyColumnMessage | VerifyEndMessage | WorkRefusedMessage;
type Asked = Omit<VerifyStartRequest, "type">;

interface Checking {
  /** What was asked; null before the first check. */
  asked: Asked | null;
  /** The assumptions in question, from the fast to the thorough. */
  plan: readonly Assumption[];
  /** The answers so far. */
  columns: readonly VerifyColumnMessage[];
  /** What is taken for granted; null while the check is on. */
  limits: readonly string[] | null;
  busy: boolean;
  /** The page asked for its end. */
  stopping: boolean;
  progress: VerifyProgressMessage | null;
  refused: WhyRefused | null;
  /** The answer whose run is open. */
  open: Cell | null;
  /** The run that is played. */
  played: ConfirmingRun | null;
}

const NOTHING: Checking = {
  asked: null,
  plan: [],
  columns: [],
  limits: null,
  busy: false,
  stopping: false,
  progress: null,
  refused: null,
  open: null,
  played: null,
};

export const useCheck = create<Checking>(() => NOTHING);

let work: Work | null = null;

function hangUp(): void {
  work?.hangUp();
  work = null;
}

/** Checks the open mission with up to so many failures of these kinds, for so many seconds at most; exactly or not. */
export function begin(failures: number, kinds: Kinds, seconds: number, approximate: boolean): void {
  hangUp();
  const { mission, file } = useStudio.getState();
  const { seed } = useRun.getState();
  const asked: Asked = { mission, path: file.path, seed, failures, kinds, seconds, approximate };
  useCheck.setState({ ...NOTHING, asked, plan: plan(failures), busy: true });
  work = beginWork<Message>("api/verify", asked, {
    onMessage: (message) => {
      useCheck.setState((state) => after(state, message));
      return message.type === "end" || message.type === "refused";
    },
    onLost: () => useCheck.setState({ busy: false, refused: { message: t("check.lost"), help: "", problems: [] } }),
  });
}

function after(state: Checking, message: Message): Partial<Checking> {
  switch (message.type) {
    case "progress":
      return { progress: message };
    case "column":
      return { columns: [...state.columns.filter((one) => !sameAssumption(one, message)), message] };
    case "end":
      return { limits: message.limits, busy: false, progress: null };
    case "refused":
      return { refused: message, busy: false, progress: null };
  }
}

/** Ends the check; what was found until then stays. */
export function breakOff(): void {
  if (work?.breakOff() === true) {
    useCheck.setState({ stopping: true });
    return;
  }
  hangUp();
  useCheck.setState({ busy: false });
}

/** The answer at a place of the table, and its assumption; null where there is none yet. */
export function answerAt(
  { plan, columns }: Pick<Checking, "plan" | "columns">,
  cell: Cell | null,
): { column: VerifyColumnMessage; answer: CheckedProperty } | null {
  const column = cell === null ? undefined : columnAt(plan, columns, cell.column);
  const answer = cell === null ? undefined : column?.properties[cell.row];
  return column === undefined || answer === undefined ? null : { column, answer };
}

/** Opens the run of an answer, or closes the one that is open. */
export function openAnswer(open: Checking["open"]): void {
  useCheck.setState({ open });
}

/** Plays the run that breaks a property, up to the moment in which it does. */
export function play(run: ConfirmingRun): void {
  const { asked } = useCheck.getState();
  if (asked === null || isHeldByRobots()) return;
  useCheck.setState({ played: run });
  playConfirming(asked, run);
}

useStudio.subscribe((studio, before) => {
  if (studio.change === before.change || studio.change.kind !== "open") return;
  hangUp();
  useCheck.setState(NOTHING);
});
