/** The page of the teacher: how to come in, how far the exercise is, a card for each pupil, and one looked on. */
import "../../../ui/search-field.css";
import "./teacher.css";

import { type RefObject, useEffect, useRef, useState } from "react";

import { classApi } from "../../../api/class";
import { partsApi } from "../../../api/parts";
import { decimal } from "../../../i18n/numbers";
import { Said } from "../../../i18n/Said";
import { type Key, t } from "../../../i18n/words";
import { useStudio } from "../../../model/studio";
import { text } from "../../../model/texts";
import { Icon } from "../../../theme";
import { Button } from "../../../ui/Button";
import { listen } from "../../../ui/effects";
import { fileDrop } from "../../../ui/file-drop";
import { Row } from "../../../ui/Row";
import { Select } from "../../../ui/Select";
import { Tool } from "../../../ui/Tool";
import { Cards } from "./Cards";
import { Head } from "./Head";
import { JoinCard, LargeJoin } from "./JoinCard";
import { Look } from "./Look";
import { counts, type Filter, FILTERS, met, type Order, ORDERS, shown } from "./order";
import { takeList } from "./MarksTool";
import { type SheetName, SHEETS } from "./Sheets";
import { act, dismissNotice, fail, filterCards, findPupils, keepDesk, look, pupilsOf, sortBy, useDesk } from "./store";

const TICK_MS = 5000;

/** A moment that goes on, so that minutes count. */
function useNow(): number {
  const [now, setNow] = useState(() => Date.now());
  const changed = useDesk(({ seen }) => seen);
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), TICK_MS);
    return () => clearInterval(timer);
  }, []);
  return Math.max(now, ...[...changed.values()].slice(0, 1).map(({ at }) => at));
}

function Bars({ change }: { change: () => void }) {
  const desk = useDesk();
  const { news } = desk;
  if (news === null) return null;
  const pupils = pupilsOf(desk);
  const count = pupils.length;
  const whole = pupils.filter((one) => news.goals.length > 0 && met(one) === news.goals.length).length;
  return (
    <section className="class-exercise surface slim" data-testid="class-exercise">
      <header className="row wrap">
        <Icon name="graduation-cap" size={18} />
        <h2 className="heading">{news.exercise === "" ? t("teacher.no-exercise") : text(news.exercise_label)}</h2>
        <span className="class-muted muted small-text">
          {news.exercise === "" ? t("teacher.no-exercise-help") : t("teacher.all-met", { done: whole, count })}
        </span>
        <Button className="to-end" testId="change-exercise" onClick={change}>
          {t(news.exercise === "" ? "teacher.choose-exercise" : "teacher.change-exercise")}
        </Button>
      </header>
      {news.goals.length === 0 ? null : (
        <ol>
          {news.goals.map(({ label }, at) => {
            const done = pupils.filter(({ goals }) => goals[at]?.reached === true).length;
            return (
              <li key={at}>
                <strong title={text(label)}>{text(label)}</strong>
                <span className="class-muted muted small-text">{t("teacher.goal-met", { done, count })}</span>
                <progress max={Math.max(1, count)} value={done} aria-label={text(label)} />
              </li>
            );
          })}
        </ol>
      )}
    </section>
  );
}

const FILTER_ICONS: Record<Filter, string> = {
  all: "",
  help: "hand",
  work: "circle-dot",
  done: "circle-check",
  away: "circle-dashed",
};

function Choice({ field }: { field: RefObject<HTMLInputElement | null> }) {
  const desk = useDesk();
  const { filter, order, find, news } = desk;
  const found = counts(pupilsOf(desk), news?.goals.length ?? 0);
  return (
    <div className="class-choice row wrap">
      <div className="class-filters wrap flex gap-xs" role="group" aria-label={t("teacher.filter")}>
        {FILTERS.map((one) => (
          <button
            key={one}
            type="button"
            className="tool tool-named rigid nowrap medium gap-m relative"
            aria-pressed={filter === one}
            data-testid={`filter-${one}`}
            onClick={() => filterCards(one)}
          >
            {FILTER_ICONS[one] === "" ? null : <Icon name={FILTER_ICONS[one]} size={16} />}
            {t(`teacher.filter-${one}` satisfies Key)}
            <span className="class-muted muted small-text">{found[one]}</span>
          </button>
        ))}
      </div>
      <Row label={t("teacher.sort")} className="class-sort" labelClass="class-muted muted small-text">
        <Select
          label={t("teacher.sort")}
          testId="sort"
          value={order}
          options={ORDERS.map((one) => [one, t(`teacher.sort-${one}` satisfies Key)] as const)}
          keep={(one) => sortBy(one as Order)}
        />
      </Row>
      <label className="class-find search-field">
        <Icon name="search" size={16} />
        <input
          className="field"
          data-testid="find"
          ref={field}
          value={find}
          dir="auto"
          placeholder={t("teacher.find")}
          aria-label={t("teacher.find")}
          onChange={(event) => findPupils(event.target.value)}
        />
      </label>
    </div>
  );
}

/** Questions and what went wrong, above everything. */
function Notices() {
  const { news, said, lost, refused } = useDesk();
  return (
    <>
      {refused || (lost !== null && news !== null) ? (
        <div className="banner row rigid gap-xl" role="alert" data-testid="class-lost">
          <Icon name="triangle-alert" size={18} />
          <p>
            <Said text={t(refused ? "teacher.wrong-key" : "teacher.lost")} />{" "}
            {refused ? <Said text={t("teacher.wrong-key-help")} /> : null}
          </p>
        </div>
      ) : null}
      {said === null ? null : (
        <div className="banner banner-note row rigid gap-xl" role="status" data-testid="class-said">
          <Icon name="info" size={18} />
          <p>
            <Said text={said.words} /> <Said text={said.help} />
          </p>
          <Tool small icon="x" label={t("banner.close")} titled={false} onClick={dismissNotice} />
        </div>
      )}
      {news?.asking.map(({ asked, name }) => (
        <div key={asked} className="banner banner-question row rigid gap-xl" role="alert" data-testid="class-asks-in">
          <Icon name="door-open" size={18} />
          <p dir="auto">{t("teacher.asks-in", { name })}</p>
          <Button onClick={() => act(classApi.answer(asked, true))}>{t("teacher.let-in")}</Button>
          <Button onClick={() => act(classApi.answer(asked, false))}>{t("teacher.not-in")}</Button>
        </div>
      ))}
    </>
  );
}

function size(bytes: number): string {
  return bytes < 100_000 ? `${decimal(Math.ceil(bytes / 1000))} kB` : `${decimal(Math.round(bytes / 100_000) / 10)} MB`;
}

function Foot({ now, count, open }: { now: number; count: number; open: (sheet: SheetName) => void }) {
  const { news, kept, lost } = useDesk();
  if (news === null) return null;
  const seconds = kept === null ? null : Math.max(0, Math.round((now - kept) / 1000));
  return (
    <footer className="class-foot row wrap rigid">
      <span className="inline-row medium" data-testid="class-all-kept">
        <Icon name={lost === null ? "circle-check" : "triangle-alert"} size={16} />
        {seconds === null
          ? t("teacher.kept-none")
          : seconds < 90
            ? t("teacher.kept", { count: seconds })
            : t("teacher.kept-long", { count: Math.round(seconds / 60) })}
      </span>
      <button
        type="button"
        className="class-plain text-button inline-row"
        data-testid="log"
        onClick={() => open("log")}
      >
        <Icon name="clipboard-list" size={16} />
        {t("teacher.log")}
      </button>
      <span className="class-muted class-foot-folder muted small-text to-end">
        <span dir="auto">{t("teacher.folder", { folder: news.folder, count, size: size(news.bytes) })}</span>
        {" · "}
        <Said text={news.reach} />
      </span>
    </footer>
  );
}

export function Teacher() {
  const desk = useDesk();
  const now = useNow();
  const [sheet, setSheet] = useState<SheetName | null>(null);
  const [large, setLarge] = useState(false);
  const find = useRef<HTMLInputElement>(null);
  useEffect(keepDesk, []);
  useEffect(() => {
    // Parts as they come with KitRobot: pictures are drawn with them.
    partsApi.catalogue("").then(({ catalogue }) => useStudio.getState().loadParts(catalogue), fail);
  }, []);
  useEffect(() => {
    const key = (event: KeyboardEvent) => {
      const typing =
        event.target instanceof Element && event.target.closest("input, select, textarea, dialog, [role=menu]");
      if (event.key === "/" && typing === null) {
        event.preventDefault();
        find.current?.focus();
      } else if (event.key === "Escape" && useDesk.getState().looked !== "" && !event.defaultPrevented) look("");
    };
    return listen(window, { keydown: key });
  }, []);

  const { news, filter, lie, seen, looked } = desk;
  const pupils = lie.flatMap((folder) => seen.get(folder)?.pupil ?? []);
  const goals = news?.goals.length ?? 0;
  const folders = shown(pupils, filter, desk.find, goals).map(({ folder }) => folder);
  const some = folders.length < pupils.length ? folders : null;
  const here = pupils.filter(({ pages }) => pages > 0).length;
  const Open = sheet === null ? null : SHEETS[sheet];
  return (
    <div className="class-page column" data-testid="teacher" {...fileDrop(takeList)}>
      <Head open={setSheet} folders={some} here={here} away={pupils.length - here} />
      <Notices />
      <div className="class-middle fill flex">
        <main className="class-main grow scroll" aria-label={t("teacher.cards")}>
          {pupils.length === 0 ? (
            <div className="class-empty gap-xl text-centre" data-testid="class-empty">
              <Bars change={() => setSheet("exercise")} />
              <JoinCard large />
              <p>{news === null ? "" : t("teacher.empty")}</p>
              {news === null ? null : (
                <p className="class-muted muted small-text">
                  <Said text={news.reach} />
                </p>
              )}
            </div>
          ) : (
            <>
              <div className="wrap flex gap-2xl">
                <Bars change={() => setSheet("exercise")} />
                <JoinCard large={false} onLarge={() => setLarge(true)} />
              </div>
              <Choice field={find} />
              <Cards folders={folders} now={now} />
            </>
          )}
        </main>
        {looked === "" ? null : <Look now={now} />}
      </div>
      <Foot now={now} count={pupils.length} open={setSheet} />
      {Open === null ? null : <Open onClose={() => setSheet(null)} folders={some} />}
      {large ? <LargeJoin onClose={() => setLarge(false)} /> : null}
    </div>
  );
}
