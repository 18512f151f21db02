/** An example as a card: what it does as a picture that moves, its title and what happens in it. */
import { type KeyboardEvent, useEffect, useRef, useState } from "react";

import type { MissionEntry, RunPreview } from "../../api/generated";
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import { complain } from "../../session/document";
import { later } from "../../ui/later";
import { previewOf } from "./missions";
import "./gallery.css";

const RunPicture = later(() => import("../../components/RunPicture").then((chunk) => chunk.RunPicture), complain);

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

/** What an example does, fetched when its card comes into sight for the first time; one that cannot be had leaves no picture. */
function usePreview(entry: MissionEntry, card: { current: Element | null }): RunPreview | null {
  const [preview, setPreview] = useState<RunPreview | null>(null);
  useEffect(() => {
    const element = card.current;
    if (element === null) return;
    let there = true;
    const sight = new IntersectionObserver((entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      sight.disconnect();
      previewOf(entry).then(
        (found) => {
          if (there) setPreview(found);
        },
        () => undefined,
      );
    });
    sight.observe(element);
    return () => {
      there = false;
      sight.disconnect();
    };
  }, [entry, card]);
  return preview;
}

export function Card({ entry, choose, brief = false, plays = false, onKeyDown }: CardProps) {
  const card = useRef<HTMLButtonElement>(null);
  const preview = usePreview(entry, card);
  const [near, setNear] = useState(false);
  return (
    <button
      type="button"
      ref={card}
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
      <span className="card-picture">
        {preview === null ? null : <RunPicture preview={preview} plays={plays || near} />}
      </span>
      <strong>{text(entry.label, entry.title || entry.name)}</strong>
      <small>{brief ? sizeWords(entry) : text(entry.help)}</small>
    </button>
  );
}
