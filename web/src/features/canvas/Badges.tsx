/** What sits on a vertex's edge: its mark, the threads that stand on it, and what is wrong with it. */
import "./breakpoint-sign.css";

import { StateShape } from "../../components/StateShape";
import { t } from "../../i18n/words";
import type { LayoutNode } from "../../model/layout";
import { otherNotes } from "../../model/notes";
import { title } from "../../model/parts";
import { shortName } from "../../model/short-name";
import { useStudio } from "../../model/studio";
import { useBreakpoint } from "../../session/breakpoints";
import { useMarkAt } from "../../session/counterexample";
import { reportError } from "../../session/document";
import { useRun } from "../../session/run";
import { Icon } from "../../theme";
import { later } from "../../ui/later";
import { NoteStrip } from "./Notes";
import { useTroubled, useTroubles } from "./problem-badges";

const Meeting = later(() => import("./Meeting").then((chunk) => chunk.Meeting), reportError);

const GuiltyVertex = later(() => import("./GuiltyVertex").then((chunk) => chunk.GuiltyVertex), reportError);

/** Where members of the team wait for others, who is there and who is missing. */
function MeetingAt({ vertex }: { vertex: string }) {
  const program = useStudio((studio) => studio.activeProgram);
  const meeting = useRun((run) =>
    run.team?.meetings.find((one) => one.vertex === vertex && one.program === program && one.missing.length > 0),
  );
  return meeting === undefined ? null : <Meeting meeting={meeting} />;
}

export function Badges({ node, threads }: { node: LayoutNode; threads: string }) {
  return (
    <>
      {node.mark === null ? null : <Mark name={title(node.mark.shape)} colour={node.mark.shape.colour} />}
      <Threads threads={threads} />
      <MeetingAt vertex={node.vertex} />
      <Troubles node={node} />
      <Noted node={node} />
      <NoteStrip node={node} />
      <BreakpointSign node={node} />
    </>
  );
}

/** Its own problem, or the first one of what is folded in it. */
function Troubles({ node: { vertex, inside } }: { node: LayoutNode }) {
  const id = useTroubled(vertex, inside?.vertices ?? NOTHING);
  return <Trouble id={id} />;
}

const NOTHING: string[] = [];

/** The sign of a note behind it or at the end of its body. */
function Noted({ node }: { node: LayoutNode }) {
  const said = otherNotes(node.block?.vertex.notes ?? []);
  if (said === "") return null;
  return (
    <span className="noted centred muted" title={said}>
      <Icon name="message-circle" size={12} label={t("graph.note", { text: said })} />
    </span>
  );
}

function Mark({ name, colour }: { name: string; colour: string }) {
  return (
    <span
      className="mark"
      title={name}
      style={{ background: `var(--${colour}-tile)`, color: `var(--${colour}-on-tile)` }}
    >
      <svg width="24" height="24" viewBox="0 0 24 24" aria-hidden="true">
        <circle cx="12" cy="12" r="4.5" fill="none" stroke="currentColor" strokeWidth="2.75" />
      </svg>
    </span>
  );
}

/** The ink pills ▶n. */
export function Threads({ threads }: { threads: string }) {
  if (threads === "") return null;
  return (
    <span className="threads">
      {[...new Set(threads.split(" "))].map((number) =>
        number.startsWith("@") ? (
          <Member key={number} at={Number(number.slice(1))} />
        ) : (
          <span key={number} className="thread inline-row ink" title={t("graph.thread", { number })}>
            <svg width="7" height="8" viewBox="0 0 7 8" aria-hidden="true">
              <path d="M0 0.5v7L6.5 4Z" fill="currentColor" />
            </svg>
            {number}
          </span>
        ),
      )}
    </span>
  );
}

/** A member of a team that stands there: its state and number, and whom it stands for. */
function Member({ at }: { at: number }) {
  const agent = useRun((run) => run.agents[at]);
  const stands = useRun((run) => run.team?.members.find((one) => one.name === agent?.name)?.stands_for);
  if (agent === undefined) return null;
  const other = stands === undefined || stands === "" || stands === agent.name ? "" : ` ← ${stands}`;
  return (
    <span className="thread inline-row ink" data-testid={`member-${agent.name}`} title={`${agent.name}${other}`}>
      <StateShape state={agent.state} />
      <bdi>{shortName(agent.name)}</bdi>
    </span>
  );
}

/** Told apart by shape, as in the list of problems; red is for STOP only. */
const SIGNS = { error: "octagon-x", warning: "triangle-alert", hint: "lightbulb" } as const;

export function Trouble({ id }: { id: string }) {
  const troubles = useTroubles(id);
  const mark = useMarkAt(id);
  const [worst] = troubles;
  if (mark !== undefined) return <GuiltyVertex mark={mark} />;
  if (worst === undefined) return null;
  const says = troubles.map(({ message, help }) => (help === "" ? message : `${message} ${help}`)).join("\n");
  return (
    <span className="trouble badge" data-severity={worst.severity} data-testid={`problem-${id}`} title={says}>
      <Icon name={SIGNS[worst.severity]} size={14} label={t("graph.problem", { message: says })} />
    </span>
  );
}

/** The sign at the edge of a vertex that a run pauses there: full when it is on, hollow when it is off. */
function BreakpointSign({ node }: { node: LayoutNode }) {
  const breakpoint = useBreakpoint(node);
  const reached = useRun(({ hits }) => hits.some((hit) => hit.vertex === breakpoint?.vertex));
  if (breakpoint === undefined) return null;
  const { when = "", hits = 1, enabled = true, agents = [] } = breakpoint;
  const says = [
    t(enabled ? "debug.breakpoint" : "debug.breakpoint-off"),
    when === "" ? "" : t("debug.says-when", { when }),
    hits === 1 ? "" : t("debug.says-hits", { hits }),
    agents.length === 0 ? "" : agents.join(", "),
  ];
  const label = says.filter((one) => one !== "").join(" · ");
  return (
    <span
      className="breakpoint"
      role="img"
      aria-label={label}
      title={label}
      data-testid={`breakpoint-${node.vertex}`}
      data-off={!enabled}
      data-more={when !== "" || hits !== 1 || agents.length > 0}
      data-reached={reached}
    />
  );
}
