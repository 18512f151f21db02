/** The examples with pictures of what they do: by level, with a search and filters. */
import { type KeyboardEvent, useRef, useState } from "react";
import { create } from "zustand";

import type { MissionEntry } from "../../api/generated";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { nextCard } from "../../ui/grid";
import { SearchField } from "../../ui/SearchField";
import { Select } from "../../ui/Select";
import { readStored, writeStored } from "../../ui/browser-storage";
import { Card } from "./Card";
import { ALL, byLevel, fitting, robotsOf, topicsOf, type Wish } from "./filter";

const LEVELS = [1, 2, 3] as const;

interface ChipProps {
  label: string;
  pressed: boolean;
  testId: string;
  choose: () => void;
}

function Chip({ label, pressed, testId, choose }: ChipProps) {
  return (
    <button
      type="button"
      className="gallery-chip finger small-text hover"
      aria-pressed={pressed}
      data-testid={testId}
      onClick={choose}
    >
      {label}
    </button>
  );
}

interface GalleryProps {
  examples: readonly MissionEntry[];
  open: (entry: MissionEntry) => void;
}

export function Gallery({ examples, open }: GalleryProps) {
  const [wish, setWish] = useState<Wish>(ALL);
  const plays = usePlays(({ on }) => on);
  const room = useRef<HTMLElement>(null);
  const field = useRef<HTMLInputElement>(null);
  const robots = useStudio((studio) => studio.catalogue.robots);
  const robotName = (name: string) => text(robots.find((one) => one.name === name)?.label ?? {}, name);
  const found = fitting(examples, wish, text, robotName);
  const change = (part: Partial<Wish>) => {
    setWish({ ...wish, ...part });
  };

  const cards = () => [...(room.current?.querySelectorAll<HTMLElement>(".card") ?? [])];
  const move = (event: KeyboardEvent<HTMLButtonElement>) => {
    const all = cards();
    const places = all.map((card) => card.getBoundingClientRect());
    const to = nextCard(event.key, all.indexOf(event.currentTarget), places, document.dir === "rtl");
    if (to === null) return;
    event.preventDefault();
    (all[to] ?? field.current)?.focus();
  };

  return (
    <section className="gallery-room" aria-label={t("open.examples")} ref={room} data-testid="gallery">
      <div className="gallery-tools row wrap">
        <SearchField
          className="gallery-find"
          label={t("gallery.find")}
          testId="gallery-find"
          field={field}
          value={wish.words}
          set={(words) => change({ words })}
          onKeyDown={(event) => {
            if (event.key !== "ArrowDown" && event.key !== "Enter") return;
            event.preventDefault();
            cards()[0]?.focus();
          }}
        />
        <Select
          className="field gallery-robot slim"
          label={t("gallery.robot")}
          testId="gallery-robot"
          value={wish.robot}
          options={[
            ["", t("gallery.robot-all")],
            ...robotsOf(examples).map((name) => [name, robotName(name)] as const),
          ]}
          keep={(robot) => change({ robot })}
        />
        <Checkbox className="finger" testId="gallery-plays" checked={plays} set={playsAlways}>
          {t("gallery.move")}
        </Checkbox>
      </div>
      <div className="gallery-chips row wrap" role="group" aria-label={t("gallery.level")}>
        <Chip
          label={t("gallery.level-all")}
          pressed={wish.level === 0}
          testId="gallery-level-0"
          choose={() => change({ level: 0 })}
        />
        {LEVELS.map((level) => (
          <Chip
            key={level}
            label={t(`gallery.level-${level}`)}
            pressed={wish.level === level}
            testId={`gallery-level-${String(level)}`}
            choose={() => change({ level })}
          />
        ))}
      </div>
      <div className="gallery-chips row wrap" role="group" aria-label={t("gallery.topic")}>
        <Chip
          label={t("gallery.topic-all")}
          pressed={wish.topic === ""}
          testId="gallery-topic-all"
          choose={() => change({ topic: "" })}
        />
        {topicsOf(examples).map(({ name, label }) => (
          <Chip
            key={name}
            label={text(label, name)}
            pressed={wish.topic === name}
            testId={`gallery-topic-${name}`}
            choose={() => change({ topic: name })}
          />
        ))}
      </div>
      <p className="gallery-count muted small-text" role="status" data-testid="gallery-count">
        {found.length === 0 ? t("gallery.none") : t("gallery.count", { count: found.length })}
      </p>
      {found.length === 0 ? (
        <Button testId="gallery-show-all" onClick={() => setWish(ALL)}>
          {t("gallery.show-all")}
        </Button>
      ) : null}
      {byLevel(found).map(({ level, entries }) => (
        <div key={level} className="gallery-level">
          <h4>{t(`gallery.level-${level === 1 || level === 2 || level === 3 ? level : 0}`)}</h4>
          <ul className="gallery gap-2xl card-grid">
            {entries.map((entry) => (
              <li key={entry.path}>
                <Card entry={entry} plays={plays} choose={() => open(entry)} onKeyDown={move} />
              </li>
            ))}
          </ul>
        </div>
      ))}
    </section>
  );
}

/** Whether pictures of the gallery move by themselves; remembered in this browser. */
const KEY = "kitrobot.gallery-still";

export const usePlays = create<{ on: boolean }>(() => ({ on: readStored(KEY) === null }));

function playsAlways(on: boolean): void {
  usePlays.setState({ on });
  writeStored(KEY, on ? null : "yes");
}
