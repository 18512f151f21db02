/** The checklist of the exercise that is open, docked above the graph. */
import "./exercise.css";

import { useEffect, useRef } from "react";

import { NextLesson } from "../../components/NextLesson";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { isHeldByRobots } from "../../session/confirming-run";
import { useOpenExercise, workPlace } from "../../session/open-exercise";
import { isShown } from "../../session/simple-view";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { Tool } from "../../ui/Tool";
import { judgeAll, keepExercise, leave, openExercise, play, stopJudging, useExercise } from "./exercise-session";
import { groundOf, type Mark, OPEN } from "./marks";

const ICONS = { open: "circle", reached: "circle-check", missed: "circle-x" } as const;
const WORDS = {
  open: "exercise.goal-open",
  reached: "exercise.goal-reached",
  missed: "exercise.goal-missed",
} as const;

function Goal({ label, mark, at }: { label: string; mark: Mark; at: number }) {
  const ground = groundOf(mark);
  const seconds = mark.seconds === null ? null : mark.seconds.toFixed(1);
  return (
    <li
      className="exercise-goal wrap flex items-start"
      data-state={mark.state}
      data-testid={`exercise-goal-${String(at + 1)}`}
    >
      <Icon name={ICONS[mark.state]} size={18} label={t(WORDS[mark.state])} />
      <span className="exercise-goal-words column slim">
        <span>{label}</span>
        {ground === "" ? null : (
          <span className="muted small-text breakable">
            <Said text={ground} />
          </span>
        )}
      </span>
      {mark.seed === null ? null : (
        <Button
          icon="play"
          iconSize={14}
          className="small"

          disabled={isHeldByRobots()}
          onClick={() => play(mark)}
        >
          {seconds === null ? t("exercise.play") : t("exercise.play-at", { seconds })}
        </Button>
      )}
    </li>
  );
}

/** What the marks are of, in a sentence. */
function basisWords(): string {
  const { basis, busy, old, marks } = useExercise.getState();
  if (busy !== null) return t("exercise.judging", { done: busy.done, total: busy.total });
  if (old && basis.kind !== "none") return t("exercise.changed");
  if (basis.kind === "run")
    return isShown("seed") ? t("exercise.after-run", { seed: basis.seed }) : t("exercise.after-one");
  if (basis.kind === "stopped") return t("exercise.stopped");
  if (basis.kind === "none") return t("exercise.not-yet");
  if (marks.every(({ state }) => state === "reached")) return t("exercise.all-done");
  return t("exercise.judged", { count: basis.runs });
}

export function ExercisePanel() {
  const { marks, busy } = useExercise();
  const open = useOpenExercise((state) => state.open);
  const comments = useOpenExercise((state) => state.comments);
  const handIn = useOpenExercise((state) => state.handIn);
  const path = useStudio((studio) => workPlace(studio.file));
  const section = useRef<HTMLElement>(null);
  useEffect(keepExercise, []);
  const exercise = openExercise();
  // Its mission may still be on the way.
  const shown = open?.path === path ? exercise : null;
  const name = shown?.name;
  useEffect(() => {
    if (name !== undefined) section.current?.focus();
  }, [name]);
  if (shown === null) return null;
  const comment = comments[shown.name];
  const done = marks.filter(({ state }) => state === "reached").length;
  const said = basisWords();
  return (
    <section
      ref={section}
      className="exercise lesson rigid scroll focus-inside"
      tabIndex={-1}
      data-testid="exercise"
      aria-label={t("exercise.of", { name: text(shown.label) })}
    >
      <header className="exercise-head lesson-head row wrap relative">
        <Icon name={shown.icon} size={18} />
        <h2 className="panel-title">{text(shown.label)}</h2>
        <span className="exercise-count muted small-text" data-testid="exercise-count">
          {t("exercise.reached", { done, total: shown.goals.length })}
        </span>
        {busy === null ? (
          <Button icon="list-checks" className="small" testId="exercise-judge" onClick={judgeAll}>
            {t("exercise.judge")}
          </Button>
        ) : (
          <Button icon="square" className="small" testId="exercise-stop" onClick={stopJudging}>
            {t("exercise.stop")}
          </Button>
        )}
        {handIn === null ? null : (
          <Button icon="upload" className="small" testId="exercise-hand-in" onClick={handIn}>
            {t("exercise.hand-in")}
          </Button>
        )}
        <Tool
          small
          icon="x"
          className="exercise-leave"
          label={t("exercise.leave")}
          testId="exercise-leave"
          onClick={leave}
        />
      </header>
      <p className="exercise-help prose">{text(shown.help)}</p>
      {comment === undefined ? null : (
        <p className="exercise-comment row gap-m prose" role="status" data-testid="exercise-comment">
          <Icon name="message-circle" size={16} />
          <span dir="auto">{t("exercise.comment", { text: comment })}</span>
        </p>
      )}
      <ol className="exercise-goals">
        {shown.goals.map((goal, at) => (
          <Goal key={at} at={at} label={text(goal.label)} mark={marks[at] ?? OPEN} />
        ))}
      </ol>
      {busy === null ? null : <progress aria-label={said} max={Math.max(1, busy.total)} value={busy.done} />}
      <p className="exercise-basis muted small-text" role="status" data-testid="exercise-basis">
        {said}
      </p>
      <div className="exercise-next">
        <NextLesson testId="exercise-next" takesFocus />
      </div>
    </section>
  );
}
