/** An example as a card: its picture, its title and what happens in it. */
import type { MissionEntry } from "../../api/generated";
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import { complain } from "../../session/document";
import { later } from "../../ui/later";
import "./gallery.css";

const Picture = later(() => import("../../components/WorldPicture").then((chunk) => chunk.Picture), complain);

interface CardProps {
  entry: MissionEntry;
  choose: () => void;
  /** Without the sentence: title and size only. */
  brief?: boolean;
}

function sizeWords({ picture }: MissionEntry): string {
  if (picture === null) return "";
  const robots = t("examples.robots", { count: picture.agents.length });
  // Start and Stop are in every program and are not counted.
  return picture.agents.length > 2
    ? robots
    : `${t("examples.parts", { count: picture.program.vertices.length - 2 })} · ${robots}`;
}

export function Card({ entry, choose, brief = false }: CardProps) {
  return (
    <button
      type="button"
      className="card"
      data-path={entry.path}
      data-testid={`example-${entry.name}`}
      onClick={choose}
    >
      <span className="card-picture">{entry.picture === null ? null : <Picture picture={entry.picture} />}</span>
      <strong>{text(entry.label, entry.title || entry.name)}</strong>
      <small>{brief ? sizeWords(entry) : text(entry.help)}</small>
    </button>
  );
}
