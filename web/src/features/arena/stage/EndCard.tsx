/**
 * What the run did, as a card over the arena, and ways on. The arena stays as large as it is, and its camera shows what
 * matters above the card. It goes with its ✕ and with the next run.
 */
import CircleCheck from "lucide-react/icons/circle-check";
import CircleX from "lucide-react/icons/circle-x";
import Download from "lucide-react/icons/download";
import Locate from "lucide-react/icons/locate-fixed";
import Play from "lucide-react/icons/rotate-ccw";
import TriangleAlert from "lucide-react/icons/triangle-alert";
import { useEffect, useRef, useState } from "react";
import { create } from "zustand";

import type { RunEvent } from "../../../api/wire";
import { NextLesson } from "../../../components/NextLesson";
import type { Painter } from "../../../components/scene/painter";
import { PanelSlot } from "../../../components/Slot";
import { clock } from "../../../i18n/numbers";
import { Said } from "../../../i18n/Said";
import { t } from "../../../i18n/words";
import { useStudio } from "../../../model/studio";
import { nextOfOpen, openLesson, useLessons } from "../../../session/lessons";
import { can, isEnded, type RunState, useRun } from "../../../session/run";
import { Icon } from "../../../theme";
import { Button } from "../../../ui/Button";
import { accountOf, type Facts, type Tone } from "./account";
import { hasDrawn, saveDrawing } from "./save-drawing";

/** What is known of the run that ended last, and its name. */
const useFacts = create<{ facts: Facts | null; run: string }>(() => ({ facts: null, run: "" }));

export function setFacts(facts: Facts, run: string): void {
  useFacts.setState({ facts, run });
}

const SIGNS = { goal: CircleCheck, plain: CircleCheck, nothing: TriangleAlert, failure: CircleX } satisfies Record<
  Tone,
  unknown
>;
/** Room below the card and above it, in px. */
const AROUND_PX = 20;

/** Tells the camera how much of the arena the card covers. */
function useCover(painter: Painter, shown: boolean) {
  const card = useRef<HTMLElement>(null);
  useEffect(() => {
    const element = card.current;
    if (!shown || element === null) return;
    const watcher = new ResizeObserver(() => painter.setCovered(element.offsetHeight + AROUND_PX));
    watcher.observe(element);
    return () => {
      watcher.disconnect();
      painter.setCovered(0);
    };
  }, [painter, shown]);
  return card;
}

export function EndCard({ painter }: { painter: Painter }) {
  const run = useRun();
  const own = useLessons((lessons) => openLesson(lessons) === null);
  const goesOn = useLessons((lessons) => nextOfOpen(lessons) !== null);
  const { facts, run: known } = useFacts();
  const [closed, setClosed] = useState("");
  const { sentence, status, name, tick, real } = run;
  const shown = sentence !== "" && !real && isEnded(status) && closed !== name && facts !== null && known === name;
  const card = useCover(painter, shown);
  if (!shown) return null;
  const { tone, title, more } = accountOf(facts);
  const cause = status === "done" ? null : causeOf(run);
  const seeks = can("seek", run);
  const saves = own && hasDrawn();
  const Sign = SIGNS[tone];
  return (
    <section
      className="stage-ending surface"
      data-tone={tone}
      data-testid="ending"
      aria-label={t("arena.result")}
      ref={card}
    >
      <Sign size={20} aria-hidden="true" />
      <div className="stage-ending-words slim breakable">
        <p className="bold">
          <Said text={title} />
        </p>
        {[more.slice(0, 1), more.slice(1)].map((said, rest) =>
          said.length === 0 ? null : (
            <p key={rest} className="stage-ending-more" data-rest={rest > 0}>
              <Said text={said.join(" ")} />
            </p>
          ),
        )}
        {cause === null || cause.text === "" ? null : (
          <p className="stage-ending-more">
            {t("arena.cause", { time: clock((cause.tick * run.tickMs) / 1000) })} <Said text={cause.text} />
          </p>
        )}
        <div className="stage-ending-more">
          <PanelSlot place="ending" />
        </div>
      </div>
      {seeks || goesOn || saves ? (
        <span className="stage-ending-ways wrap flex gap-m" data-next={goesOn}>
          <NextLesson testId="ending-next" />
          {!seeks || cause === null || cause.tick >= tick ? null : (
            <Button
              testId="go-to-cause"
              onClick={() => {
                const program = run.agents.find((agent) => agent.name === cause.agent)?.program;
                if (program !== undefined) {
                  useStudio.getState().setActiveProgram(program);
                  run.selectAgent(cause.agent, program);
                }
                run.seek(cause.tick);
              }}
            >
              <Locate size={16} aria-hidden="true" />
              <span>{t("arena.go-to-cause")}</span>
            </Button>
          )}
          {seeks ? (
            <Button
              testId="watch-again"
              onClick={() => {
                run.seek(0);
                run.resume();
              }}
            >
              <Play size={16} aria-hidden="true" />
              <span>{t("arena.watch-again")}</span>
            </Button>
          ) : null}
          {saves ? (
            <Button testId="ending-save-drawing" onClick={() => saveDrawing(false)}>
              <Download size={16} aria-hidden="true" />
              <span>{t("arena.save-drawing")}</span>
            </Button>
          ) : null}
        </span>
      ) : null}
      <button
        type="button"
        className="tool small rigid"
        aria-label={t("arena.close-result")}
        data-testid="ending-close"
        onClick={() => setClosed(name)}
      >
        <Icon name="x" />
      </button>
    </section>
  );
}

/** What a run that did not end well came from: the last thing before its end that went wrong. */
const WRONG: readonly RunEvent["kind"][] = ["failure", "collision"];

interface Cause {
  tick: number;
  agent: string;
  text: string;
}

/**
 * The last failure or collision; else the last that anybody did before the end. Null where nothing happened: then nothing
 * is known but the end itself.
 */
export function causeOf({ events, tick }: Pick<RunState, "events" | "tick">): Cause | null {
  const before = events.filter((event) => event.tick <= tick && event.kind !== "end");
  return before.findLast(({ kind }) => WRONG.includes(kind)) ?? before.at(-1) ?? null;
}
