/** The tutorial that is on, docked above the graph: the step to do now, how far it is, and the ways on. */
import "./tutorial.css";

import { useEffect, useRef } from "react";

import type { Tutorial } from "../../api/generated";
import { NextLesson } from "../../components/NextLesson";
import { t } from "../../i18n/words";
import { partsOf } from "../../model/parts";
import { programInView, useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { Tool } from "../../ui/Tool";
import { beginAnew } from "./opening";
import { goToPoint, type Page, selectorOf, told, wordsOf } from "./points";
import { doneSteps } from "./progress";
import { goBack, goForward, goTo, leave, showHint, useTutorial } from "./state";
import { keepWatching } from "./step-watch";

function usePage(): Page {
  const program = useStudio(programInView);
  const catalogue = useStudio((studio) => studio.catalogue);
  return { program, parts: partsOf(catalogue, program?.robot ?? "") };
}

function nameOf(tutorial: Tutorial, step: number, page: Page): string {
  return told(tutorial.steps[step]?.label ?? {}, page);
}

interface StepProps {
  tutorial: Tutorial;
  done: readonly boolean[];
  page: Page;
}

/** The steps as numbers: each a button that goes there. */
function Steps({ tutorial, done, page }: StepProps) {
  const { at, skipped } = useTutorial((state) => state.progress);
  return (
    <ol className="wrap flex gap-xs" aria-label={t("tutorial.steps")}>
      {done.map((is, step) => {
        const state = is ? "done" : skipped.includes(step) ? "skipped" : "open";
        const words = { number: step + 1, name: nameOf(tutorial, step, page) };
        const label = t(
          is ? "tutorial.step-done" : state === "skipped" ? "tutorial.step-skipped" : "tutorial.step",
          words,
        );
        return (
          <li key={step}>
            <button
              type="button"
              className="tutorial-dot muted centred tiny-text"
              data-state={state}
              data-testid={`tutorial-step-${String(step + 1)}`}
              aria-label={label}
              aria-current={step === at ? "step" : undefined}
              title={label}
              onClick={() => goTo(step)}
            >
              {is ? <Icon name="check" size={14} /> : step + 1}
            </button>
          </li>
        );
      })}
    </ol>
  );
}

/** One calm ring around everything that the step points at; it closes in on it for who asked to be shown. */
function Ring({ selector, shown }: { selector: string; shown: boolean }) {
  if (selector === "") return null;
  const closing = shown ? "animation: var(--tutorial-shown);" : "";
  return (
    <style data-testid="tutorial-ring">
      {`:root:root :is(${selector}) { outline: var(--tutorial-ring); outline-offset: var(--tutorial-ring-away); border-radius: var(--radius-inner); ${closing} }`}
    </style>
  );
}

function StepView({ tutorial, done, page }: StepProps) {
  const { progress, hinted } = useTutorial();
  const step = tutorial.steps[progress.at];
  if (step === undefined) return null;
  const is = done[progress.at] === true;
  const read = !step.asks && step.events.length === 0;
  const hint = told(step.hint, page);
  const points = step.points.filter((point) => selectorOf(point, page) !== "");
  return (
    <>
      {is ? null : <Ring selector={points.map((point) => selectorOf(point, page)).join(", ")} shown={hinted} />}
      <div className="tutorial-words slim">
        <h3>{told(step.label, page)}</h3>
        <p>{told(step.help, page)}</p>
        {is ? (
          <p className="tutorial-is-done items-start">
            <Icon name="circle-check" size={16} /> {t("tutorial.is-done")}
          </p>
        ) : null}
        {hinted && hint !== "" ? (
          <p className="tutorial-hint items-start" role="status" data-testid="tutorial-hint">
            <Icon name="lightbulb" size={16} />
            <span>
              <strong>{t("tutorial.hint")}</strong> {hint}
            </span>
          </p>
        ) : null}
        {hinted ? (
          <ul className="tutorial-points wrap flex gap-m">
            {points.map((point) => (
              <li key={`${point.kind} ${point.name}`}>
                <Button
                  icon="crosshair"
                  iconSize={14}
                  className="small"

                  testId={`tutorial-go-${point.kind}-${point.name}`}
                  onClick={() => goToPoint(point, page)}
                >
                  {t("tutorial.go", { what: wordsOf(point, page) })}
                </Button>
              </li>
            ))}
          </ul>
        ) : null}
      </div>
      <div className="rigid flex to-end gap-m">
        {is || hinted || (hint === "" && points.length === 0) ? null : (
          <Button
            icon="lightbulb"
            testId="tutorial-show"
            onClick={() => {
              showHint();
              const [first] = points;
              if (first !== undefined) goToPoint(first, page);
            }}
          >
            {t("tutorial.show-me")}
          </Button>
        )}
        <Button testId="tutorial-back" disabled={progress.at === 0} onClick={goBack}>
          {t("tutorial.back")}
        </Button>
        <Button testId="tutorial-next" onClick={goForward}>
          {t(is || read ? "tutorial.next" : "tutorial.skip")}
        </Button>
      </div>
    </>
  );
}

function End({ tutorial, done, page }: StepProps) {
  const whole = done.every(Boolean);
  const open = done.findIndex((is) => !is);
  return (
    <>
      <div className="tutorial-words slim" data-testid="tutorial-end">
        <h3>{whole ? t("tutorial.finished", { name: text(tutorial.label) }) : t("tutorial.left-over")}</h3>
        <p>{whole ? t("tutorial.finished-help") : t("tutorial.open-again", { number: open + 1 })}</p>
      </div>
      <div className="rigid flex to-end gap-m">
        <NextLesson testId="tutorial-next-one" takesFocus />
        {whole ? (
          <Button onClick={() => beginAnew(tutorial)} testId="tutorial-again">
            {t("tutorial.again")}
          </Button>
        ) : (
          <Button onClick={() => goTo(open)} testId="tutorial-open-step">
            {t("tutorial.step", { number: open + 1, name: nameOf(tutorial, open, page) })}
          </Button>
        )}
        <Button onClick={leave} testId="tutorial-close">
          {t("tutorial.leave")}
        </Button>
      </div>
    </>
  );
}

/** What is said aloud: what was done, and what comes now. */
function spoken({ tutorial, done, page }: StepProps, at: number, last: number): string {
  const did = last >= 0 ? `${t("tutorial.did", { name: nameOf(tutorial, last, page) })} ` : "";
  const step = tutorial.steps[at];
  if (step !== undefined) {
    return `${did}${t("tutorial.step", { number: at + 1, name: told(step.label, page) })}. ${told(step.help, page)}`;
  }
  return did + (done.every(Boolean) ? t("tutorial.finished", { name: text(tutorial.label) }) : t("tutorial.left-over"));
}

export function TutorialPanel() {
  const { tutorial, progress, fits, last } = useTutorial();
  const page = usePage();
  const section = useRef<HTMLElement>(null);
  const name = tutorial?.name;
  useEffect(keepWatching, []);
  useEffect(() => {
    if (name !== undefined) section.current?.focus();
  }, [name]);
  if (tutorial === null) return null;
  const done = doneSteps(tutorial, fits, progress);
  const count = done.filter(Boolean).length;
  const undone = done.findIndex((is, step) => !is && step < progress.at && !progress.skipped.includes(step));
  return (
    <section
      ref={section}
      className="tutorial lesson rigid focus-inside"
      tabIndex={-1}
      data-testid="tutorial"
      data-step={progress.at + 1}
      aria-label={t("tutorial.of", { name: text(tutorial.label) })}
    >
      <header className="tutorial-head lesson-head row wrap">
        <Icon name={tutorial.icon} size={18} />
        <h2 className="panel-title">{text(tutorial.label)}</h2>
        <Steps tutorial={tutorial} done={done} page={page} />
        <span className="muted small-text" data-testid="tutorial-count">
          {t("tutorial.done-of", { done: count, total: done.length })}
        </span>
        {progress.at < done.length && undone >= 0 ? (
          <button
            type="button"
            className="tutorial-undone small-text inline-row medium gap-xs"
            data-testid="tutorial-undone"
            onClick={() => goTo(undone)}
          >
            <Icon name="undo-2" size={14} />
            {t("tutorial.open-again", { number: undone + 1 })}
          </button>
        ) : null}
        <Tool
          small
          icon="x"
          className="tutorial-leave to-end"
          label={t("tutorial.leave")}
          testId="tutorial-leave"
          onClick={leave}
        />
      </header>
      <div className="tutorial-body wrap flex">
        {progress.at < done.length ? (
          <StepView tutorial={tutorial} done={done} page={page} />
        ) : (
          <End tutorial={tutorial} done={done} page={page} />
        )}
      </div>
      <p className="only-spoken" role="status" data-testid="tutorial-said">
        {spoken({ tutorial, done, page }, progress.at, last)}
      </p>
    </section>
  );
}
