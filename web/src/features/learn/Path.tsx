/** Lessons as cards in the order of the path: a picture, a tick where it is learned, and what a teacher wants to know. */
import { type KeyboardEvent, useRef, useState } from "react";

import { MissionPicture } from "../../components/MissionPicture";
import type { TeacherPage } from "../../api/generated";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import { type Lesson, nextLesson } from "../../session/lesson";
import { useLessons } from "../../session/lessons";
import { Icon } from "../../theme";
import { nextCard } from "../../ui/grid";

interface CardProps {
  lesson: Lesson;
  learned: boolean;
  /** Whether the path goes on here. */
  next: boolean;
  brief: boolean;
  onKeyDown: (event: KeyboardEvent<HTMLButtonElement>) => void;
}

function Card({ lesson, learned, next, brief, onKeyDown }: CardProps) {
  const [near, setNear] = useState(false);
  return (
    <button
      type="button"
      className="learn-card card surface column"
      data-testid={`${lesson.kind}-${brief ? "offer" : "card"}-${lesson.name}`}
      data-learned={learned}
      aria-current={next ? "step" : undefined}
      onClick={lesson.begin}
      onKeyDown={onKeyDown}
      onPointerEnter={() => setNear(true)}
      onPointerLeave={() => setNear(false)}
      onFocus={() => setNear(true)}
      onBlur={() => setNear(false)}
    >
      <MissionPicture className="learn-picture card-picture relative" path={lesson.start} plays={near}>
        <span className="learn-icon centred ink">
          <Icon name={lesson.icon} size={brief ? 22 : 26} />
        </span>
      </MissionPicture>
      {learned ? (
        <span className="learn-tick badge card-tick">
          <Icon name="check" size={16} label={t("learn.learned")} />
        </span>
      ) : null}
      <strong>{text(lesson.label)}</strong>
      {brief ? null : <span className="learn-help muted small-text breakable">{text(lesson.help)}</span>}
      <small>
        {t(`learn.${lesson.kind}`)} · {lesson.far()}
      </small>
    </button>
  );
}

/** One that has a mistake: its author sees which. */
function Broken({ lesson: { kind, name, problems } }: { lesson: Lesson }) {
  const [first] = problems;
  return (
    <div className="learn-card is-broken card surface column" data-testid={`${kind}-card-${name}`}>
      <span className="learn-picture card-picture relative">
        <span className="learn-icon centred ink">
          <Icon name="triangle-alert" size={26} />
        </span>
      </span>
      <strong dir="auto">{name}</strong>
      <span className="learn-help muted small-text breakable">
        {t(kind === "tutorial" ? "tutorial.broken" : "exercise.broken")}{" "}
        {first === undefined ? null : <Said text={t("banner.line", { line: first.line, message: first.message })} />}
      </span>
    </div>
  );
}

/** What a teacher wants to know of it. */
function Teachers({ page }: { page: TeacherPage }) {
  const lists = [
    { title: t("tutorial.troubles"), texts: page.troubles },
    { title: t("tutorial.questions"), texts: page.questions },
  ];
  return (
    <details className="learn-teachers small-text">
      <summary className="finger">{t("tutorial.teachers", { count: page.minutes })}</summary>
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

interface PathProps {
  lessons: readonly Lesson[];
  /** Under an empty program: without the sentences. */
  brief?: boolean;
}

export function Path({ lessons, brief = false }: PathProps) {
  const room = useRef<HTMLOListElement>(null);
  const learned = useLessons((state) => state.learned);
  const next = nextLesson(lessons, learned, "");
  const move = (event: KeyboardEvent<HTMLButtonElement>) => {
    const cards = [...(room.current?.querySelectorAll<HTMLElement>("button.learn-card") ?? [])];
    const places = cards.map((card) => card.getBoundingClientRect());
    const to = nextCard(event.key, cards.indexOf(event.currentTarget), places, document.dir === "rtl");
    if (to === null) return;
    event.preventDefault();
    cards[to]?.focus();
  };
  return (
    <ol className="learn-path start-text card-grid" ref={room}>
      {lessons.map((lesson) => (
        <li key={lesson.name}>
          {lesson.usable ? (
            <Card
              lesson={lesson}
              learned={learned.includes(lesson.name)}
              next={lesson.name === next?.name}
              brief={brief}
              onKeyDown={move}
            />
          ) : (
            <Broken lesson={lesson} />
          )}
          {brief || lesson.teacher === null ? null : <Teachers page={lesson.teacher} />}
        </li>
      ))}
    </ol>
  );
}
