/** A walk by hand: the state in pictures and words, the steps that are possible in it, and the way back. */
import "./broken-run.css";
import "./walked-state.css";

import { useEffect } from "react";

import type { PossibleStep, StateWalk } from "../../api/generated";
import { Refusal } from "../../components/Refusal";
import { grouped, readWhole } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import type { Mission } from "../../model/types";
import { type CounterexampleMark, markVertices } from "../../session/counterexample";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { Row } from "../../ui/Row";
import { Select } from "../../ui/Select";
import { Tool } from "../../ui/Tool";
import { FAILURE_COUNTS } from "./kinds";
import { SceneArena } from "./SceneArena";
import { assume, closeWalk, goBack, goOn, takeStep, useStateWalk } from "./state-walk";
import { TIMINGS } from "./table";
import { useWorldOf } from "./world";

export function WalkedState() {
  const { wanted, state, refused } = useStateWalk();
  useEffect(() => {
    if (state === null) return;
    markVertices(marksOf(state));
    return () => markVertices([]);
  }, [state]);
  if (wanted === null) return null;
  return (
    <section className="check-run walk column scroll gap-m" data-testid="walk" aria-label={t("walk.title")}>
      <header className="row between">
        <h3 className="panel-title">{t("walk.title")}</h3>
        <Tool small icon="x" label={t("walk.close")} titled={false} testId="walk-close" onClick={closeWalk} />
      </header>
      <Assumption />
      <Refusal refused={refused} />
      {state === null ? null : <State state={state} mission={wanted.mission} />}
    </section>
  );
}

/** When agents tick, and how many robots may fail; another choice begins anew. */
function Assumption() {
  const wanted = useStateWalk((walk) => walk.wanted);
  if (wanted === null) return null;
  const { timing, failures = 0 } = wanted;
  return (
    <div className="row wrap small-text">
      <Row label={t("walk.timing")}>
        <Select
          label={t("walk.timing")}
          testId="walk-timing"
          value={timing}
          options={TIMINGS.map((one) => [one, t(`check.${one}-means`)])}
          keep={(value) => assume({ timing: TIMINGS.find((one) => one === value) ?? "free", failures })}
        />
      </Row>
      <Row label={t("check.failures")}>
        <Select
          label={t("check.failures")}
          testId="walk-failures"
          value={String(failures)}
          options={FAILURE_COUNTS}
          keep={(value) => assume({ timing, failures: readWhole(value) ?? 0 })}
        />
      </Row>
    </div>
  );
}

function State({ state, mission }: { state: StateWalk; mission: Mission }) {
  const busy = useStateWalk((walk) => walk.busy);
  const world = useWorldOf(mission);
  const { places, happened, situation, shared, possible, more } = state;
  const ordinary = possible.filter((step) => !step.is_failure);
  const failures = possible.filter((step) => step.is_failure);
  const first = places.length === 0;
  return (
    <>
      {world === null ? null : <SceneArena scene={state.scene} mission={mission} world={world} />}
      <div role="status" className="column walk-state gap-xs" data-testid="walk-state" data-step={places.length}>
        <p>
          <strong>{t("walk.state", { number: grouped(places.length) })}</strong> <Sentences texts={happened} />
        </p>
        {situation.map((sentence, index) => (
          <p key={index} className="row gap-xs items-start">
            <Icon name="triangle-alert" size={16} />
            <span>
              <Said text={sentence} />
            </span>
          </p>
        ))}
      </div>
      <div className="row wrap">
        <Button icon="undo-2" testId="walk-back" disabled={first} onClick={() => goBack()}>
          {t("walk.back")}
        </Button>
        <Button icon="step-forward" testId="walk-on" disabled={busy || ordinary.length !== 1} onClick={goOn}>
          {t("walk.on")}
        </Button>
        <Tool
          icon="rotate-cw"
          label={t("walk.anew")}
          testId="walk-anew"
          disabled={first}
          onClick={() => goBack(true)}
        />
      </div>
      <h4>{possible.length === 0 ? t("walk.nothing") : t("walk.possible")}</h4>
      <Steps steps={ordinary} />
      {failures.length === 0 ? null : (
        <details>
          <summary>{t("walk.failures", { count: failures.length })}</summary>
          <Steps steps={failures} />
        </details>
      )}
      {more === 0 ? null : <p className="muted small-text">{t("walk.more", { count: more })}</p>}
      {shared.length === 0 ? null : <p className="muted small-text breakable">{shared.join(" · ")}</p>}
    </>
  );
}

/** The steps as buttons; one that breaks a property, or leads back, says so. */
function Steps({ steps }: { steps: readonly PossibleStep[] }) {
  const busy = useStateWalk((walk) => walk.busy);
  return (
    <ol className="walk-steps column gap-xs">
      {steps.map(({ place, sentences, breaks, returns_to: returns }, index) => (
        <li key={index}>
          <Button
            className="walk-step wrap start-text"
            testId={`walk-step-${String(place)}`}
            aria-disabled={busy}
            onClick={() => {
              if (!busy) takeStep(place);
            }}
          >
            <span>
              <Sentences texts={sentences} />
            </span>
            {breaks.length === 0 ? null : (
              <span className="row bold gap-2xs">
                <Icon name="triangle-alert" size={14} />
                {t("walk.breaks", { properties: breaks.join(", ") })}
              </span>
            )}
            {returns < 0 ? null : (
              <span className="muted small-text">{t("walk.returns", { number: grouped(returns) })}</span>
            )}
          </Button>
        </li>
      ))}
    </ol>
  );
}

function Sentences({ texts }: { texts: readonly string[] }) {
  return texts.map((text, index) => (
    <span key={index}>
      {index === 0 ? "" : "; "}
      <Said text={text} />
    </span>
  ));
}

/** Where the programs are, on the graph. */
function marksOf({ scene }: StateWalk): CounterexampleMark[] {
  return scene.robots.flatMap(({ at }) =>
    at.map(([program, vertex]) => ({
      ...{ program, vertex, sentence: "", robots: [], repeats: false },
      steps: [scene.step],
    })),
  );
}
