/** Under the teaching text of an empty program: examples to open instead. */
import { t } from "../../i18n/words";
import { show } from "../../session/document";
import { openPath } from "../../session/open-requests";
import { Card } from "./Card";
import { useMissions } from "./missions";
import "../../ui/sheets.css";

const MOST = 4;

/** The easiest ones, and the last: where it leads to. */
function first<T>(all: readonly T[]): T[] {
  return all.length <= MOST ? [...all] : [...all.slice(0, MOST - 1), ...all.slice(-1)];
}

export function Examples() {
  const examples = first((useMissions() ?? []).filter((entry) => entry.example !== null));
  if (examples.length === 0) return null;
  return (
    <section className="examples start-text" aria-label={t("open.examples")}>
      <div className="flex between row">
        <h2>{t("examples.or")}</h2>
        <button type="button" className="text-button muted" data-testid="all-examples" onClick={() => show("open")}>
          {t("examples.all")}
        </button>
      </div>
      <ul className="gallery gap-2xl card-grid">
        {examples.map((entry) => (
          <li key={entry.path}>
            <Card entry={entry} brief choose={() => openPath(entry.path)} />
          </li>
        ))}
      </ul>
    </section>
  );
}
