/** The tutorials as a row of cards: in the gallery, under an empty program, and in the welcome. */
import type { ReactNode } from "react";

import type { TeacherPage, Tutorial } from "../../api/generated";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import { Icon } from "../../theme";
import { begin } from "./opening";
import { rememberedProgress } from "./progress";
import { useTutorial } from "./state";
import "./tutorial.css";

function state(tutorial: Tutorial): string {
  const total = tutorial.steps.length;
  const progress = rememberedProgress(tutorial);
  if (progress === null) return t("tutorial.count", { count: total });
  return progress.at >= total ? t("tutorial.all-done") : t("tutorial.at", { number: progress.at + 1, total });
}

function Card({ tutorial, brief }: { tutorial: Tutorial; brief: boolean }) {
  return (
    <button
      type="button"
      className="tutorial-card surface"
      data-testid={`tutorial-card-${tutorial.name}`}
      onClick={() => void begin(tutorial)}
    >
      <span className="tutorial-card-icon rigid">
        <Icon name={tutorial.icon} size={22} />
      </span>
      <span>
        <strong>{text(tutorial.label)}</strong>
        {brief ? null : <span className="tutorial-card-help muted small-text">{text(tutorial.help)}</span>}
        <small>{state(tutorial)}</small>
      </span>
    </button>
  );
}

/** What a teacher wants to know of it. */
function Teachers({ page }: { page: TeacherPage }) {
  const lists = [
    { title: t("tutorial.troubles"), texts: page.troubles },
    { title: t("tutorial.questions"), texts: page.questions },
  ];
  return (
    <details className="tutorial-teachers small-text">
      <summary>{t("tutorial.teachers", { count: page.minutes })}</summary>
      <p>{text(page.aim)}</p>
      {lists
        .filter(({ texts }) => texts.length > 0)
        .map(({ title, texts }) => (
          <div key={title}>
            <h4>{title}</h4>
            <ul>
              {texts.map((one, at) => (
                <li key={at}>{text(one)}</li>
              ))}
            </ul>
          </div>
        ))}
    </details>
  );
}

/** One that has a mistake: its author sees which. */
function Broken({ tutorial: { name, problems } }: { tutorial: Tutorial }) {
  const [first] = problems;
  return (
    <div className="tutorial-card is-broken surface" data-testid={`tutorial-card-${name}`}>
      <span className="tutorial-card-icon rigid">
        <Icon name="triangle-alert" size={22} />
      </span>
      <span>
        <strong>{name}</strong>
        <span className="tutorial-card-help muted small-text">
          {t("tutorial.broken")}{" "}
          {first === undefined ? null : <Said text={t("banner.line", { line: first.line, message: first.message })} />}
        </span>
      </span>
    </div>
  );
}

/** Under an empty program there is room for so many. */
const MOST = 4;

/** The first ones that are not done; the first ones where all are. */
function nextTutorials(all: readonly Tutorial[]): Tutorial[] {
  const usable = all.filter(({ steps }) => steps.length > 0);
  const open = usable.filter((one) => (rememberedProgress(one)?.at ?? 0) < one.steps.length);
  return (open.length > 0 ? open : usable).slice(0, MOST);
}

interface CardsProps {
  /** Under an empty program: the next few, without the sentences. */
  brief?: boolean;
}

export function TutorialCards({ brief = false }: CardsProps) {
  const all = useTutorial((found) => found.all) ?? [];
  const shown = brief ? nextTutorials(all) : all;
  if (shown.length === 0) return null;
  return (
    <section className="tutorial-cards" aria-label={t("tutorial.title")}>
      {brief ? <h2>{t("tutorial.invite")}</h2> : <h3>{t("tutorial.title")}</h3>}
      <ul>
        {shown.map((one) => (
          <li key={one.name}>
            {one.steps.length > 0 ? <Card tutorial={one} brief={brief} /> : <Broken tutorial={one} />}
            {brief || one.teacher === null ? null : <Teachers page={one.teacher} />}
          </li>
        ))}
      </ul>
    </section>
  );
}

/**
 * Above what else is offered under an empty program; nothing while a tutorial is open. All of it is drawn at once, so that
 * no card moves away from under a pointer.
 */
export function Invitation({ children }: { children: ReactNode }) {
  const shown = useTutorial(({ tutorial, all }) => tutorial === null && all !== null);
  if (!shown) return null;
  return (
    <>
      <TutorialCards brief />
      {children}
    </>
  );
}
