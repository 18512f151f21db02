/** An example as a card: what it does as a picture that moves, its title and what happens in it. */
import { type KeyboardEvent, useState } from "react";

import type { MissionEntry } from "../../api/generated";
import { MissionPicture } from "../../components/MissionPicture";
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import "./gallery.css";

interface CardProps {
  entry: MissionEntry;
  choose: () => void;
  /** Without the sentence: title and size only. */
  brief?: boolean;
  /** Whether its picture moves while it is seen; else only under the pointer or the focus. */
  plays?: boolean;
  onKeyDown?: (event: KeyboardEvent<HTMLButtonElement>) => void;
}

function sizeWords({ example }: MissionEntry): string {
  if (example === null || example.agents === 0) return "";
  const robots = t("examples.robots", { count: example.agents });
  return example.agents > 2 ? robots : `${t("examples.parts", { count: example.parts })} · ${robots}`;
}

export function Card({ entry, choose, brief = false, plays = false, onKeyDown }: CardProps) {
  const [near, setNear] = useState(false);
  return (
    <button
      type="button"
      className="card surface column"
      data-path={entry.path}
      data-testid={`example-${entry.name}`}
      onClick={choose}
      onKeyDown={onKeyDown}
      onPointerEnter={() => setNear(true)}
      onPointerLeave={() => setNear(false)}
      onFocus={() => setNear(true)}
      onBlur={() => setNear(false)}
    >
      <MissionPicture className="card-picture" path={entry.path} modified={entry.modified} plays={plays || near} />
      <strong>{text(entry.label, entry.title || entry.name)}</strong>
      <small>{brief ? sizeWords(entry) : text(entry.help)}</small>
    </button>
  );
}
