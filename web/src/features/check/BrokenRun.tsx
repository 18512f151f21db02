/** How a property is broken: whether the simulator shows it too, playing that run, and the model's run in sentences. */
import "./broken-run.css";

import { useEffect, useRef, useState } from "react";

import type { CheckedEvent, CheckedProperty, ConfirmingRun } from "../../api/generated";
import { clock, grouped } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { isHeldByRobots } from "../../session/confirming-run";
import { markVertices } from "../../session/counterexample";
import { useRun } from "../../session/run";
import { closeTeam } from "../../session/team-view";
import { useView } from "../../session/view";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { Tool } from "../../ui/Tool";
import { BothWays } from "./BothWays";
import { USUAL } from "./kinds";
import { beginWalk } from "./state-walk";
import { StepArena } from "./StepArena";
import { type Cell, counterexampleMarks, stretches } from "./table";
import { assumptionWords } from "./Verdict";
import { answerAt, openAnswer, play, useCheck } from "./check-session";
import { WhyBroken } from "./WhyBroken";

export function BrokenRun({ cell }: { cell: Cell }) {
  const shown = answerAt(
    {
      plan: useCheck((check) => check.plan),
      columns: useCheck((check) => check.columns),
    },
    cell,
  );
  const place = useRef<HTMLElement>(null);
  useEffect(() => {
    // Not returned: newer browsers give a promise.
    place.current?.scrollIntoView({ block: "start" });
  }, []);
  const [showsOther, setShowsOther] = useState(false);
  const asked = useCheck((check) => check.asked);
  const mission = asked?.mission;
  const wrong = shown?.answer;
  useEffect(() => {
    if (wrong === undefined || mission === undefined) return;
    const marks = counterexampleMarks(
      wrong,
      mission.agents.map(({ name }) => name),
    );
    markVertices(marks);
    return () => markVertices([]);
  }, [wrong, mission]);
  const first = wrong?.guilty[0];
  useEffect(() => {
    if (first !== undefined) showVertex(first.program, first.vertex);
  }, [first?.program, first?.vertex]); // eslint-disable-line react-hooks/exhaustive-deps
  if (shown === null || asked === null || mission === undefined) return null;
  const { answer, column } = shown;
  const other = showsOther ? (answer.why?.other ?? null) : null;
  const close = () => setShowsOther(false);
  return (
    <section className="check-run column scroll gap-m" ref={place} data-testid="check-run" aria-label={t("check.run")}>
      <header className="row between">
        <h3 className="panel-title">{t("check.broken-under", { assumption: assumptionWords(column) })}</h3>
        <Tool small icon="x" label={t("check.run-close")} titled={false} onClick={() => openAnswer(null)} />
      </header>
      <p className="check-sentence block">
        <Said text={answer.sentence} />
      </p>
      <Seen answer={answer} />
      <WhyBroken answer={answer} onOther={() => setShowsOther(true)} />
      {other === null ? null : <BothWays answer={answer} other={other} asked={asked} onClose={close} />}
      {answer.confirmed === null ? <StepArena run={answer} mission={mission} decided={answer.why?.step ?? -1} /> : null}
      {answer.places.length === 0 ? null : (
        <p className="check-play row lesson-head">
          <Button
            icon="step-forward"
            testId="check-walk"
            onClick={() => beginWalk(column, { ...asked, kinds: asked.kinds ?? USUAL }, placesBefore(answer))}
          >
            {t("walk.from-here")}
          </Button>
        </p>
      )}
      <Story answer={answer} />
    </section>
  );
}

/** The steps of a run before the one that decided it; where none is known, before its last one. */
function placesBefore({ places, why }: CheckedProperty): number[] {
  const decided = why?.step ?? -1;
  return places.slice(0, decided >= 0 ? decided : -1);
}

/** Brings a vertex into view, where the mission still has it. */
function showVertex(program: string, vertex: string): void {
  const { mission, setActiveProgram } = useStudio.getState();
  const there = mission.programs.find(({ name }) => name === program)?.vertices.some(({ id }) => id === vertex);
  if (there !== true) return;
  closeTeam();
  setActiveProgram(program);
  // The canvas draws the other program first.
  requestAnimationFrame(() => useView.getState().viewport?.reveal(vertex));
}

function failureWords({ agent, at_s, kind }: ConfirmingRun["failures"][number]): string {
  return t(`check.befalls-${kind}`, { agent, time: clock(at_s) });
}

/** Whether the simulator shows it too. */
function Seen({ answer }: { answer: CheckedProperty }) {
  const held = useRun(isHeldByRobots);
  const busy = useCheck((check) => check.busy);
  const played = useCheck((check) => check.played === answer.confirmed);
  const { confirmed: run, searched } = answer;
  if (run === null) {
    const words = searched ? t("check.not-reproduced") : busy ? t("check.searching") : t("check.not-searched");
    return (
      <p className="check-seen flex gap-m items-start" data-testid="check-seen" data-confirmed="false">
        <span className="check-dashed rigid" aria-hidden="true" />
        {words}
      </p>
    );
  }
  return (
    <>
      <p className="check-seen flex gap-m items-start" data-testid="check-seen" data-confirmed="true">
        <Icon name="circle-check" size={16} />
        <span>
          <strong>{t("check.confirmed", { seed: String(run.seed), time: clock(run.seconds) })}</strong>
          {run.failures.map((one, index) => (
            <span key={index}> {failureWords(one)}</span>
          ))}
        </span>
      </p>
      <p className="check-play row wrap lesson-head">
        <Button icon="play" testId="check-play" disabled={held} onClick={() => play(run)}>
          {t("check.play")}
        </Button>
        {played ? <span className="muted">{t("check.plays", { time: clock(run.seconds) })}</span> : null}
        {held ? <span className="warning">{t("check.real")}</span> : null}
      </p>
    </>
  );
}

/** The run of the model. */
function Story({ answer }: { answer: CheckedProperty }) {
  const parts = stretches(answer);
  const last = parts.at(-1);
  return (
    <div className="check-story" data-testid="check-story">
      {parts.map(({ repeats, events }, index) => (
        <div key={index} data-repeats={repeats}>
          {repeats ? (
            <h4 className="panel-title">
              <Icon name="infinity" size={16} />
              {events.length === 0 ? t("check.stays") : t("check.repeats")}
            </h4>
          ) : null}
          <Events events={events} leftOut={answer.left_out} decided={answer.why?.step ?? -1} />
        </div>
      ))}
      {last !== undefined && !last.repeats && last.events.length === 0 ? (
        <p className="muted">{t("check.at-once")}</p>
      ) : null}
    </div>
  );
}

/** Events are left out in the middle of a long run: there is where the numbers of steps leap most. */
function Events({ events, leftOut, decided }: { events: readonly CheckedEvent[]; leftOut: number; decided: number }) {
  const gap = leftOut === 0 ? -1 : events.findIndex(({ step }, index) => step - (events[index - 1]?.step ?? step) > 1);
  return (
    <ol>
      {events.map(({ step, text }, index) => (
        <li key={index} data-decided={step === decided || undefined}>
          {index === gap ? (
            <span className="check-left-out muted">{t("check.left-out", { count: leftOut })}</span>
          ) : null}
          <span className="check-step muted figures">{events[index - 1]?.step === step ? "" : grouped(step + 1)}</span>
          <span>
            <Said text={text} />
            {step === decided && events[index - 1]?.step !== decided ? (
              <span className="row regular gap-xs">
                <Icon name="git-fork" size={14} />
                {t("check.decides")}
              </span>
            ) : null}
          </span>
        </li>
      ))}
    </ol>
  );
}
