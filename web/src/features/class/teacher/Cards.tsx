/** The cards of the pupils: picture, name, state, goals. Arrows walk them, Enter looks on. */
import { type KeyboardEvent, memo, useRef } from "react";

import { GraphPicture } from "../../../components/WorldPicture";
import { mirrored } from "../../../i18n/language";
import { t } from "../../../i18n/words";
import { Icon } from "../../../theme";
import { met, minutes, type Seen, stateWords, walkCards } from "./order";
import { look, useDesk } from "./store";

/** So many pupils have cards of twice the size, and fit on a screen. */
const FEW = 8;

export function Boxes({ goals, count }: { goals: Seen["pupil"]["goals"]; count: number }) {
  if (count === 0) return null;
  return (
    <span className="class-boxes rigid" aria-hidden="true">
      {Array.from({ length: Math.min(count, 10) }, (_, at) => (
        <span key={at} className="class-box centred" data-met={goals[at]?.reached === true}>
          {goals[at]?.reached === true ? <Icon name="check" size={10} /> : null}
        </span>
      ))}
    </span>
  );
}

interface CardProps {
  seen: Seen;
  goals: number;
  /** Minutes, so that a card is drawn anew only when its words change. */
  now: number;
  chosen: boolean;
  tab: boolean;
}

const Card = memo(function Card({ seen, goals, now, chosen, tab }: CardProps) {
  const { pupil } = seen;
  const picture = useDesk(({ pictures }) => pictures.get(pupil.folder)?.program ?? null);
  const { icon, words, calls } = stateWords(seen, goals, now);
  const asked = pupil.state === "asks" ? minutes(seen, now) : null;
  return (
    <button
      type="button"
      className="class-card card surface column slim"
      data-card={pupil.folder}
      data-testid={`card-${pupil.folder}`}
      data-state={pupil.state}
      data-calls={calls}
      data-running={pupil.running}
      aria-pressed={chosen}
      tabIndex={tab ? 0 : -1}
      data-frozen={pupil.frozen}
      onClick={() => look(chosen ? "" : pupil.folder)}
    >
      <span className="class-picture card-picture fill" aria-hidden="true">
        {picture === null ? null : <GraphPicture program={picture} />}
      </span>
      <span className="class-name row small-text rigid slim gap-s">
        <strong className="ellipsis" dir="auto">
          {pupil.name}
        </strong>
        {pupil.frozen ? (
          <>
            <Icon name="snowflake" size={14} />
            <span className="only-spoken">{`, ${t("teacher.is-frozen")} `}</span>
          </>
        ) : null}
        {asked === null || asked === 0 ? null : <small>{t("teacher.minutes", { count: asked })}</small>}
      </span>
      <span className="class-state row small-text rigid muted slim gap-s">
        <Icon name={icon} size={14} />
        <span className="ellipsis">{words}</span>
      </span>
      <span className="class-goals row small-text rigid between slim gap-s">
        <Boxes goals={pupil.goals} count={goals} />
        {goals === 0 ? (
          <small className="ellipsis" dir="auto">
            {pupil.file}
          </small>
        ) : (
          <>
            <small dir="ltr" aria-hidden="true">{`${String(met(pupil))}/${String(goals)}`}</small>
            <span className="only-spoken">{t("teacher.goals", { done: met(pupil), count: goals })}</span>
          </>
        )}
      </span>
    </button>
  );
});

export function Cards({ folders, now }: { folders: readonly string[]; now: number }) {
  const { seen, looked, news } = useDesk();
  const grid = useRef<HTMLDivElement>(null);
  const goals = news?.goals.length ?? 0;
  const first = folders.includes(looked) ? looked : folders[0];

  const onKeyDown = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const cards = [...(grid.current?.querySelectorAll<HTMLElement>("[data-card]") ?? [])];
    const at = cards.findIndex((card) => card === document.activeElement);
    const top = cards[0]?.offsetTop;
    const columns = Math.max(1, cards.filter((card) => card.offsetTop === top).length);
    const to = at < 0 ? null : walkCards(event.key, at, cards.length, columns, mirrored());
    if (to === null) return;
    event.preventDefault();
    cards[to]?.focus();
  };

  if (folders.length === 0) return <p className="class-nobody muted text-centre">{t("teacher.nobody")}</p>;
  return (
    <div
      className="class-cards gap-xl"
      role="group"
      aria-label={t("teacher.cards")}
      data-few={seen.size <= FEW}
      ref={grid}
      onKeyDown={onKeyDown}
    >
      {folders.map((folder) => {
        const one = seen.get(folder);
        return one === undefined ? null : (
          <Card key={folder} seen={one} goals={goals} now={now} chosen={looked === folder} tab={folder === first} />
        );
      })}
    </div>
  );
}
