/**
 * The page of a new mission, over all but the head: three rows of pictures, and beside them what was chosen, running.
 *
 * It is one form: Enter begins from anywhere in it. Its rows are radio groups of the browser's own.
 */
import { type ReactNode, useEffect, useRef, useState } from "react";
import { create } from "zustand";

import { beginningsApi } from "../../api/beginnings";
import type { Ability, Beginnings, Preview } from "../../api/generated";
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import { closeOverlay, complain, show } from "../../session/document";
import { beginMission } from "../../session/open-requests";
import { Icon } from "../../theme";
import { later } from "../../ui/later";
import { Tool } from "../../ui/Tool";
import { type Choice, chosenPlace, fittingFirst, NOTHING, placeFits, settled, starterFits } from "./choosing";
import { RobotsPicture } from "./RobotsPicture";
import { Stage } from "./Stage";
import "./new-mission.css";

const GraphPicture = later(() => import("../../components/WorldPicture").then((chunk) => chunk.GraphPicture), complain);

/** What was chosen last stays chosen while the page is open. */
const useLastChoice = create<Choice>(() => ({ kit: "", place: "", starter: "" }));

function useBeginnings(): Beginnings | null {
  const [all, setAll] = useState<Beginnings | null>(null);
  useEffect(() => {
    let there = true;
    beginningsApi.all().then(
      (found) => {
        if (there) setAll(found);
      },
      (cause: unknown) => {
        if (!there) return;
        closeOverlay();
        complain(cause);
      },
    );
    return () => {
      there = false;
    };
  }, []);
  return all;
}

/** How the starters of a kit run in a place; those of the choice before are gone at once. */
function usePreviews({ kit, place }: Choice): Preview[] {
  const [found, setFound] = useState<{ of: string; previews: Preview[] }>({ of: "", previews: [] });
  const wanted = `${kit} ${place}`;
  useEffect(() => {
    if (kit === "" || place === "") return;
    let there = true;
    beginningsApi.previews(kit, place).then(
      (previews) => {
        if (there) setFound({ of: `${kit} ${place}`, previews });
      },
      (cause: unknown) => {
        if (there) complain(cause);
      },
    );
    return () => {
      there = false;
    };
  }, [kit, place]);
  return found.of === wanted ? found.previews : [];
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
    <label className="new-card" data-chosen={chosen} data-off={reason !== ""}>
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
      <span className="new-picture">{children}</span>
      <strong>{label}</strong>
      <small>{reason || help}</small>
      {chosen ? (
        <span className="new-tick">
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
        <span className="new-number" aria-hidden="true">
          {number}
        </span>
        {title}
      </legend>
      <div className="new-cards">{children}</div>
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

export function NewMission() {
  const all = useBeginnings();
  return all === null || all.kits.length === 0 ? null : <Form all={all} />;
}

function Form({ all }: { all: Beginnings }) {
  const choice = settled(all, useLastChoice());
  const [name, setName] = useState(t("new.name-first"));
  const form = useRef<HTMLFormElement>(null);
  const previews = usePreviews(choice);
  const preview = previews.find(({ starter }) => starter === choice.starter);
  const place = chosenPlace(all, choice);
  const kit = all.kits.find((one) => one.name === choice.kit);
  const starter = all.starters.find((one) => one.name === choice.starter);

  useEffect(() => {
    const before = document.activeElement;
    form.current?.querySelector<HTMLElement>("input:checked")?.focus();
    return () => {
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);

  const choose = (wish: Partial<Choice>) => {
    useLastChoice.setState(settled(all, { ...choice, ...wish }));
  };
  const starters = fittingFirst(all.starters, (one) => starterFits(one, choice)).filter(
    (one) => one.places[choice.kit] !== undefined,
  );

  return (
    <form
      className="new-mission"
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
        beginMission(() => beginningsApi.mission(choice.kit, choice.place, choice.starter), name);
      }}
    >
      <main className="new-rows">
        <h2 id="new-title">{t("new.title")}</h2>
        <p>{t("new.help")}</p>
        <Row number={1} title={t("new.robot")}>
          {all.kits.map((one) => (
            <Card
              key={one.name}
              row="kit"
              value={one.name}
              label={text(one.label, one.name)}
              help={text(one.help)}
              chosen={one.name === choice.kit}
              choose={() => choose({ kit: one.name })}
            >
              <RobotsPicture robots={one.robots} />
            </Card>
          ))}
        </Row>
        <Row number={2} title={t("new.place")}>
          {fittingFirst(all.places, (one) => placeFits(all, choice.kit, one.name)).map((one) => (
            <Card
              key={one.name}
              row="place"
              value={one.name}
              label={text(one.label, one.name)}
              help={text(one.help)}
              chosen={one.name === choice.place}
              reason={placeFits(all, choice.kit, one.name) ? "" : t("new.place-not")}
              choose={() => choose({ place: one.name })}
            >
              <Stage world={one.world} tracks={[]} still />
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
            {previews
              .filter((one) => one.starter === NOTHING)
              .map((one) => (
                <GraphPicture key={one.starter} program={one.program} />
              ))}
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
              {place === undefined ? null : (
                <Stage
                  world={place.world}
                  tracks={previews.find(({ starter: name }) => name === one.name)?.tracks ?? []}
                  close
                  still
                />
              )}
            </Card>
          ))}
        </Row>
      </main>
      <aside className="new-side" aria-label={t("new.yours")}>
        <div className="new-side-head">
          <h2>{t("new.yours")}</h2>
          <Tool small icon="x" label={t("help.close")} titled={false} onClick={closeOverlay} />
        </div>
        <div className="new-stage">
          {place === undefined ? null : (
            <Stage key={`${choice.kit} ${choice.starter}`} world={place.world} tracks={preview?.tracks ?? []} />
          )}
        </div>
        <p className="new-sentence" role="status">
          {t(choice.starter === NOTHING ? "new.sentence-nothing" : "new.sentence", {
            robot: kit === undefined ? "" : text(kit.label, kit.name),
            place: place === undefined ? "" : text(place.label, place.name),
            starter: starter === undefined ? "" : text(starter.label, starter.name),
          })}
        </p>
        <div className="new-both">
          <Abilities title={t("new.can")} all={kit?.can ?? []} />
          <Abilities title={t("new.feels")} all={kit?.feels ?? []} />
        </div>
        {preview === undefined || choice.starter === NOTHING ? null : (
          <section className="new-program">
            <h3>{t("new.program")}</h3>
            <div className="new-graph">
              <GraphPicture program={preview.program} />
            </div>
          </section>
        )}
        <div className="new-end">
          <label className="field-label" htmlFor="new-name">
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
          <button type="submit" className="new-begin" data-testid="new-begin">
            <Icon name="arrow-right" size={18} />
            {t("new.begin")}
            <kbd aria-hidden="true">Enter</kbd>
          </button>
          <button type="button" className="new-all" onClick={() => show("open")}>
            {t("examples.all")}
          </button>
        </div>
      </aside>
    </form>
  );
}
