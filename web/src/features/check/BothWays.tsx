/**
 * How a property broke and another way that keeps it, side by side and in step, over the whole of the page's work.
 *
 * Where the simulator has a run it is played; else the states of the model are shown, spread over the same time.
 */
import "./both-ways.css";

import { useCallback, useEffect, useMemo, useRef, useState } from "react";
import { createPortal } from "react-dom";

import type { CheckedProperty, OtherWay, RunStretch } from "../../api/generated";
import { failureWords } from "../../api/refusal";
import { useRunCanvas } from "../../components/run-canvas";
import { boxOf } from "../../components/scene/play";
import { clock, decimal, grouped } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { Mission, World } from "../../model/types";
import { Icon } from "../../theme";
import { borrowFocus } from "../../ui/borrow-focus";
import { Sheet } from "../../ui/Sheet";
import { useFetched } from "../../ui/use-fetched";
import { frameAt, lastEvent, type Recorded, recordWays, type Span, spanOf } from "./both-ways";
import { SceneArena } from "./SceneArena";
import { SceneEvents } from "./SceneEvents";
import { StepBar, stepByKey, STEPS_A_SECOND, useSteps } from "./StepBar";
import { type ModelRun, momentsFrom, otherRun, sceneAt } from "./table";
import { useWorldOf } from "./world";

/** Seconds of a step through runs of the simulator. */
const STEP_S = 0.2;

interface Props {
  answer: CheckedProperty;
  other: OtherWay;
  asked: { mission: Mission; path: string };
  onClose: () => void;
}

export function BothWays(props: Props) {
  const { answer, asked, onClose } = props;
  const world = useWorldOf(asked.mission);
  const span = useMemo(() => spanOf(answer), [answer]);
  const [refused, setRefused] = useState("");
  const record = useCallback(() => recordWays(asked, answer, span), [asked, answer, span]);
  const recorded = useFetched(record, (cause): Recorded => {
    setRefused(failureWords(cause));
    return { broken: null, kept: null };
  });
  const changed = useStudio(({ mission }) => mission !== asked.mission);
  const room = document.querySelector("main")?.parentElement ?? document.body;
  // What is covered is not there for keys and screen readers either.
  useEffect(() => {
    const covered = [...room.children].filter((one) => one.tagName !== "DIALOG" && !one.hasAttribute("inert"));
    for (const one of covered) one.setAttribute("inert", "");
    return () => {
      for (const one of covered) one.removeAttribute("inert");
    };
  }, [room]);
  return createPortal(
    <Sheet whole title={t("check.both-title")} testId="check-both-ways" onClose={onClose}>
      <div className="both-ways column fill gap-m">
        <div className="check-why both-ways-why">
          <p className="check-sentence bold">
            <Said text={answer.sentence} />
          </p>
          <ol className="small-text">
            {answer.why?.sentences.map((sentence, index) => (
              <li key={index}>
                <Said text={sentence} />
              </li>
            ))}
          </ol>
          {changed ? <p className="warning small-text">{t("check.changed")}</p> : null}
          {refused === "" ? null : (
            <p className="warning small-text" role="alert">
              {refused}
            </p>
          )}
        </div>
        {recorded === null || world === null ? (
          <p className="muted fill" role="status">
            {t("check.both-coming")}
          </p>
        ) : (
          <WayComparison {...props} world={world} span={span} recorded={recorded} />
        )}
      </div>
    </Sheet>,
    room,
  );
}

interface WayComparisonProps extends Props {
  world: World;
  span: Span | null;
  recorded: Recorded;
}

function WayComparison({
  answer,
  other,
  asked: { mission },
  world,
  span,
  recorded: { broken, kept },
}: WayComparisonProps) {
  const decided = answer.why?.step ?? 0;
  const keptRun = otherRun(other);
  const moments = momentsFrom([answer, keptRun], decided);
  const last = moments.length - 1;
  const time = broken === null ? null : span;
  const length = time === null ? last : ((time.keptLast ?? time.brokenLast) - time.first) * time.tickS;
  const steps = useSteps(time === null ? { length, unit: 1, rate: STEPS_A_SECOND } : { length, unit: STEP_S, rate: 1 });
  const { at } = steps;
  const parting = time === null ? 0 : (time.parts - time.first) * time.tickS;
  const breaks = time === null ? last : (time.brokenLast - time.first) * time.tickS;
  const box = useMemo(() => {
    const ways = [broken, kept].flatMap((one) => one?.run.ways ?? []);
    return broken === null ? undefined : boxOf(world, { ...broken.run, ways });
  }, [world, broken, kept]);
  // Of the model, the states stand for as much of the time as there is behind the parting.
  const share = length > parting ? Math.max(0, at - parting) / (length - parting) : 0;
  const step = moments[time === null ? Math.floor(at) : Math.floor(share * last + 1e-6)] ?? decided;
  const isBroken = at >= breaks;
  const shared = { mission, world, step, at, parting, box };
  const play = useRef<HTMLButtonElement>(null);
  useEffect(() => borrowFocus(play.current), []);
  const words =
    time === null
      ? t("check.step-of", { step: grouped(step), steps: grouped(moments[last] ?? step) })
      : clock(time.first * time.tickS + at);
  const why = answer.why?.sentences[0] ?? "";
  const { confirmed } = answer;
  const broke =
    confirmed === null ? t("check.way-broken") : t("check.way-broken-at", { time: clock(confirmed.seconds) });
  return (
    <div
      className="column fill gap-m both-ways-play"
      tabIndex={-1}
      data-testid="check-both"
      data-step={step}
      data-at={at}
      onKeyDown={(event) => stepByKey(event, steps)}
    >
      <div className="check-both fill">
        <WayArena {...shared} name="broken" run={answer} stretch={broken} title={broke} ending={isBroken ? why : ""} />
        <WayArena
          {...shared}
          name="kept"
          run={keptRun}
          stretch={kept}
          title={
            (kept === null ? other.ends_well : answer.why?.kept?.ends_well) ? t("check.way-well") : t("check.way-kept")
          }
          note={noteOf(answer, broken, kept)}
          ending={at >= breaks ? t("check.kept-still") : ""}
        />
      </div>
      <StepBar
        steps={steps}
        label={time === null ? t("check.both-in-step") : t("check.both-in-time")}
        marks={[parting, breaks].filter((mark) => mark > 0 && mark < length)}
        words={words}
        play={play}
      >
        {words}
      </StepBar>
    </div>
  );
}

/** What is other in the way that keeps the property, or why the simulator does not show it. */
function noteOf({ why, confirmed }: CheckedProperty, broken: RunStretch | null, kept: RunStretch | null): string {
  const run = why?.kept ?? null;
  if (kept === null || run === null) return broken === null ? "" : t("check.kept-model");
  if (run.delayed === "") {
    return t("check.kept-failures", { count: (confirmed?.failures.length ?? 0) - run.failures.length });
  }
  const [agent, time] = [run.delayed, clock(run.seconds)];
  return t("check.kept-waits", { agent, time, seconds: decimal(run.delay_s) });
}

interface WayArenaProps {
  name: "broken" | "kept";
  run: ModelRun;
  stretch: RunStretch | null;
  title: string;
  /** What is other in it. */
  note?: string;
  /** What is said once the property has broken: of the one that breaks it always, else where nothing happens. */
  ending: string;
  mission: Mission;
  world: World;
  step: number;
  at: number;
  /** Where it parts from the other one. */
  parting: number;
  box: Parameters<typeof useRunCanvas>[0]["box"];
}

function WayArena({
  name,
  run,
  stretch,
  title,
  note = "",
  ending,
  mission,
  world,
  step,
  at,
  parting,
  box,
}: WayArenaProps) {
  const scene = sceneAt(run, step);
  if (stretch === null && scene === null) return null;
  const isOver = name === "broken" && ending !== "";
  const happened = stretch === null || isOver ? "" : lastEvent(stretch, parting, at);
  const said = at < parting ? t("check.both-same") : happened || ending || (parting > 0 ? t("check.both-part") : "");
  return (
    <figure
      className="check-way column gap-xs"
      data-testid={`check-way-${name}`}
      data-step={scene?.step}
      data-frame={stretch === null ? undefined : Math.floor(frameAt(stretch, at))}
      data-ended={isOver}
    >
      <figcaption className="row wrap gap-xs">
        <Icon name={name === "kept" ? "circle-check" : "circle-x"} size={16} />
        <span className="bold">{title}</span>
        {stretch === null && run.repeats_from >= 0 && step > run.repeats_from ? (
          <Icon name="infinity" size={14} label={t("check.repeats")} />
        ) : null}
        {note === "" ? null : (
          <span className="muted small-text">
            <Said text={note} />
          </span>
        )}
      </figcaption>
      <div className="check-way-arena relative">
        {stretch !== null ? (
          <StretchArena stretch={stretch} world={world} box={box} at={at} />
        ) : scene === null ? null : (
          <SceneArena scene={scene} mission={mission} world={world} />
        )}
      </div>
      {stretch === null && scene !== null ? (
        <SceneEvents run={run} scene={scene} />
      ) : (
        <p className="check-way-words" aria-live="polite">
          <Said text={said} />
        </p>
      )}
    </figure>
  );
}

type StretchProps = Pick<WayArenaProps, "world" | "box" | "at"> & { stretch: RunStretch };

/** A run of the simulator at a moment. */
function StretchArena({ stretch, world, box, at }: StretchProps) {
  const [canvas, draw] = useRunCanvas({ preview: stretch.run, world, box, names: true });
  const frame = frameAt(stretch, at);
  useEffect(() => draw(frame), [draw, frame]);
  return <canvas ref={canvas} className="picture picture-run cover" aria-hidden="true" />;
}
