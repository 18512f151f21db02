/** Under the teaching text of an empty program: examples to open instead. */
import { t } from "../words/words";
import { Icon } from "../theme";
import { openPath } from "./document";
import { useMissions } from "./missions";

const MOST = 4;

export function Examples() {
  const examples = (useMissions() ?? []).filter((entry) => entry.example).slice(0, MOST);
  if (examples.length === 0) return null;
  return (
    <section className="examples" aria-label={t("open.examples")}>
      <h2>{t("examples.or")}</h2>
      <ul>
        {examples.map((entry) => (
          <li key={entry.path}>
            <button type="button" className="example" onClick={() => openPath(entry.path)}>
              <Icon name="bot" size={20} />
              <span>
                <strong>{entry.title || entry.name}</strong>
                <small>{entry.name}</small>
              </span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
