/**
 * The page of a new mission, over all but the head: three rows of pictures, and beside them what was chosen, running.
 *
 * It is one form: Enter begins from anywhere in it. Its rows are radio groups of the browser's own.
 */
import "./new-mission.css";

import { type ReactNode, useCallback, useEffect, useRef, useState } from "react";
import { create } from "zustand";

import { beginningsApi } from "../../api/beginnings";
import { api } from "../../api/client";
import type { Ability, Beginnings, Preview, RunPreview } from "../../api/generated";
import { journalApi } from "../../api/journal";
import { Doors } from "../../components/Doors";
import { t } from "../../i18n/words";
import { firstSentence, text } from "../../model/texts";
import { closeOverlay, freeMissionName, reportError, show } from "../../session/document";
import { beginMission } from "../../session/open-requests";
import { Icon } from "../../theme";
import { borrowFocus } from "../../ui/borrow-focus";
import { later } from "../../ui/later";
import { Tool } from "../../ui/Tool";
import { useFetched } from "../../ui/use-fetched";
import { type Choice, chosenPlace, fittingFirst, NOTHING, placeFits, settled, starterFits } from "./choice";
import { RobotsPicture } from "./RobotsPicture";

const GraphPicture = later(
  () => import("../../components/WorldPicture").then((chunk) => chunk.GraphPicture),
  reportError,
  { words: false },
);
const WorldPicture = later(
  () => import("../../components/WorldPicture").then((chunk) => chunk.WorldPicture),
  reportError,
  { words: false },
);
const RunPicture = later(() => import("../../components/RunPicture").then((chunk) => chunk.RunPicture), reportError, {
  words: false,
});

/** What was chosen last stays chosen while the page is open. */
const useLastChoice = create<Choice>(() => ({ robotSet: "", place: "", starter: "" }));

function useBeginnings(): Beginnings | null {
  return useFetched(beginningsApi.all, (cause) => {
    closeOverlay();
    reportError(cause);
    return null;
  });
}

async function namesTaken(): Promise<string[]> {
  const [missions, left] = await Promise.all([api.missions(), journalApi.left()]);
  return [...missions.map(({ path }) => path), ...left.map(({ name }) => name)];
}

function noNames(cause: unknown): string[] {
  reportError(cause);
  return [];
}

const NO_PREVIEWS: Preview[] = [];

/** How the starters of a robotSet run in a place; those of the choice before are gone at once. */
function usePreviews({ robotSet, place }: Choice): Preview[] {
  const ask = useCallback(
    () => (robotSet === "" || place === "" ? Promise.resolve(NO_PREVIEWS) : beginningsApi.previews(robotSet, place)),
    [robotSet, place],
  );
  const found = useFetched(ask, (cause) => {
    reportError(cause);
    return NO_PREVIEWS;
  });
  return found ?? NO_PREVIEWS;
}

interface CardProps {
  row: string;
  value: string;
  label: string;
  help: string;
  chosen: boolean;
  /** Why it cannot be had with the rest, "" when it can. */
  reason?: string;
  choose: () => void;
  children: ReactNode;
}

function Card({ row, value, label, help, chosen, reason = "", choose, children }: CardProps) {
  return (
    <label className="new-card card surface column" data-chosen={chosen} data-off={reason !== ""}>
      <input
        type="radio"
        className="only-spoken"
        name={row}
        value={value}
        checked={chosen}
        disabled={reason !== ""}
        data-testid={`new-${row}-${value}`}
        onChange={choose}
      />
      <span className="new-picture card-picture">{children}</span>
      <strong>{label}</strong>
      <small>{reason || firstSentence(help)}</small>
      {chosen ? (
        <span className="badge card-tick">
          <Icon name="check" size={14} />
        </span>
      ) : null}
    </label>
  );
}

function Row({ number, title, children }: { number: number; title: string; children: ReactNode }) {
  return (
    <fieldset className="new-row">
      <legend>
        <span className="new-number small-text centred" aria-hidden="true">
          {number}
        </span>
        {title}
      </legend>
      <div className="new-cards gap-2xl">{children}</div>
    </fieldset>
  );
}

function Abilities({ title, all }: { title: string; all: readonly Ability[] }) {
  if (all.length === 0) return null;
  return (
    <section className="new-abilities">
      <h3>{title}</h3>
      <ul>
        {all.map(({ icon, label }) => (
          <li key={label[""]}>
            <Icon name={icon} size={16} />
            {text(label, label[""])}
          </li>
        ))}
      </ul>
    </section>
  );
}

function ProgramOf({ run }: { run: RunPreview | undefined }) {
  return run === undefined || run.program === null ? null : <GraphPicture program={run.program} />;
}

function RunOf({ run, plays }: { run: RunPreview | undefined; plays: boolean }) {
  return run === undefined ? null : <RunPicture preview={run} plays={plays} />;
}

/** The place where a starter could be had. */
function PlaceOf({ all, name }: { all: Beginnings; name: string | undefined }) {
  const place = all.places.find((one) => one.name === name);
  return place === undefined ? null : <WorldPicture world={place.world} agents={[]} />;
}

export function NewMission() {
  const all = useBeginnings();
  const taken = useFetched(namesTaken, noNames);
  return all === null || taken === null || all.robot_sets.length === 0 ? null : <Form all={all} taken={taken} />;
}

function Form({ all, taken }: { all: Beginnings; taken: readonly string[] }) {
  const choice = settled(all, useLastChoice());
  const [name, setName] = useState(() => freeMissionName(t("new.name-first"), taken));
  const form = useRef<HTMLFormElement>(null);
  const previews = usePreviews(choice);
  const runOf = (name: string) => previews.find(({ starter }) => starter === name)?.run;
  const place = chosenPlace(all, choice);
  const robotSet = all.robot_sets.find((one) => one.name === choice.robotSet);
  const starter = all.starters.find((one) => one.name === choice.starter);

  useEffect(() => borrowFocus(form.current?.querySelector<HTMLElement>("input:checked")), []);

  const choose = (wish: Partial<Choice>) => {
    useLastChoice.setState(settled(all, { ...choice, ...wish }));
  };
  const starters = fittingFirst(all.starters, (one) => starterFits(one, choice)).filter(
    (one) => one.places[choice.robotSet] !== undefined,
  );

  return (
    <form
      className="new-mission fill relative"
      ref={form}
      data-testid="new-mission"
      aria-labelledby="new-title"
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        closeOverlay();
      }}
      onSubmit={(event) => {
        event.preventDefault();
        closeOverlay();
        const { robotSet, place, starter } = choice;
        beginMission(() => beginningsApi.mission(robotSet, place, starter), freeMissionName(name, taken));
      }}
    >
      <main className="new-rows scroll">
        <Doors />
        <h2 id="new-title">{t("new.title")}</h2>
        <p>{t("new.help")}</p>
        <Row number={1} title={t("new.robot")}>
          {all.robot_sets.map((one) => (
            <Card
              key={one.name}
              row="robots"
              value={one.name}
              label={text(one.label, one.name)}
              help={text(one.help) || (one.own ? t("new.own") : "")}
              chosen={one.name === choice.robotSet}
              choose={() => choose({ robotSet: one.name })}
            >
              <RobotsPicture robots={one.robots} />
            </Card>
          ))}
        </Row>
        <Row number={2} title={t("new.place")}>
          {fittingFirst(all.places, (one) => placeFits(all, choice.robotSet, one.name)).map((one) => (
            <Card
              key={one.name}
              row="place"
              value={one.name}
              label={text(one.label, one.name)}
              help={text(one.help)}
              chosen={one.name === choice.place}
              reason={placeFits(all, choice.robotSet, one.name) ? "" : t("new.place-not")}
              choose={() => choose({ place: one.name })}
            >
              <WorldPicture world={one.world} agents={one.world.starts.map(({ name }) => name)} />
            </Card>
          ))}
        </Row>
        <Row number={3} title={t("new.starter")}>
          <Card
            row="starter"
            value={NOTHING}
            label={t("new.nothing")}
            help={t("new.nothing-help")}
            chosen={choice.starter === NOTHING}
            choose={() => choose({ starter: NOTHING })}
          >
            <ProgramOf run={runOf(NOTHING)} />
          </Card>
          {starters.map((one) => (
            <Card
              key={one.name}
              row="starter"
              value={one.name}
              label={text(one.label, one.name)}
              help={text(one.help)}
              chosen={one.name === choice.starter}
              reason={starterFits(one, choice) ? "" : t("new.starter-not")}
              choose={() => choose({ starter: one.name })}
            >
              {starterFits(one, choice) ? (
                <RunOf run={runOf(one.name)} plays={false} />
              ) : (
                <PlaceOf all={all} name={one.places[choice.robotSet]?.[0]} />
              )}
            </Card>
          ))}
        </Row>
      </main>
      <aside className="new-side column scroll gap-2xl" aria-label={t("new.yours")}>
        <div className="between aligned">
          <h2>{t("new.yours")}</h2>
          <Tool small icon="x" label={t("help.close")} titled={false} onClick={closeOverlay} />
        </div>
        <div className="new-stage rigid">
          <RunOf key={`${choice.robotSet} ${choice.starter}`} run={runOf(choice.starter)} plays />
        </div>
        <p className="new-sentence bold" role="status">
          {t(choice.starter === NOTHING ? "new.sentence-nothing" : "new.sentence", {
            robot: robotSet === undefined ? "" : text(robotSet.label, robotSet.name),
            place: place === undefined ? "" : text(place.label, place.name),
            starter: starter === undefined ? "" : text(starter.label, starter.name),
          })}
        </p>
        <div className="new-about">
          <Abilities title={t("new.can")} all={robotSet?.can ?? []} />
          <Abilities title={t("new.feels")} all={robotSet?.feels ?? []} />
          {choice.starter === NOTHING || runOf(choice.starter) === undefined ? null : (
            <section className="new-program">
              <h3>{t("new.program")}</h3>
              <div className="new-graph">
                <ProgramOf run={runOf(choice.starter)} />
              </div>
            </section>
          )}
        </div>
        <div className="new-end column gap-m">
          <label className="field-title muted small-text rigid" htmlFor="new-name">
            {t("new.name")}
          </label>
          <input
            id="new-name"
            className="field"
            data-testid="new-name"
            value={name}
            maxLength={100}
            spellCheck={false}
            autoComplete="off"
            onFocus={(event) => event.target.select()}
            onChange={(event) => setName(event.target.value)}
          />
          <button type="submit" className="new-begin row bold ink justify-centre" data-testid="new-begin">
            <Icon name="arrow-right" size={18} />
            {t("new.begin")}
            <kbd aria-hidden="true">Enter</kbd>
          </button>
          <button type="button" className="new-all text-button muted" onClick={() => show("open")}>
            {t("examples.all")}
          </button>
        </div>
      </aside>
    </form>
  );
}
