/** The keys that work, and what this program is. */
import { type Key, t } from "../words/words";
import { useDocument } from "./document";
import { Sheet } from "./Sheet";

const KEYS: [keys: string, meaning: Key][] = [
  ["F5", "help.keys-run"],
  ["F6", "help.keys-pause"],
  ["F10", "help.keys-step"],
  ["Shift+F5", "help.keys-stop"],
  ["Ctrl+S", "help.keys-save"],
  ["Ctrl+O", "help.keys-open"],
  ["Ctrl+Alt+N", "help.keys-new"],
  ["Ctrl+P", "out.print"],
  ["Ctrl+Z", "help.keys-undo"],
  ["Ctrl+Y", "help.keys-redo"],
  ["F8 · Shift+F8", "help.keys-problem"],
  ["Ctrl+.", "problems.fix"],
  ["Alt", "help.keys-menu"],
  ["F1", "help.keys-part"],
  ["F4", "help.keys-outline"],
  ["?", "help.keys-this"],
];

const GRAPH_KEYS: [keys: string, meaning: Key][] = [
  ["/", "help.keys-insert"],
  ["↑ ↓ ← →", "help.keys-walk"],
  ["Enter", "help.keys-edit"],
  ["Delete", "help.keys-delete"],
  ["Ctrl+D", "help.keys-duplicate"],
  ["Ctrl+X · Ctrl+C · Ctrl+V", "help.keys-clipboard"],
  ["W · Shift+W", "help.keys-wrap"],
  ["C", "help.keys-fold"],
  ["Shift+F10", "help.keys-context"],
  ["Z", "graph.zoom-selection"],
  ["M", "graph.minimap"],
  ["F", "graph.follow"],
  ["Ctrl+F", "help.keys-find"],
  ["Ctrl+A", "help.keys-all"],
  ["+ · − · Ctrl+0", "help.keys-zoom"],
];

function Keys({ keys }: { keys: [string, Key][] }) {
  return (
    <dl className="keys">
      {keys.map(([key, meaning]) => (
        <div key={key}>
          <dt>
            <kbd>{key}</kbd>
          </dt>
          <dd>{t(meaning)}</dd>
        </div>
      ))}
    </dl>
  );
}

export function ShortcutsSheet() {
  return (
    <Sheet title={t("help.shortcuts")} testId="shortcuts-dialog">
      <Keys keys={KEYS} />
      <h3>{t("app.canvas")}</h3>
      <Keys keys={GRAPH_KEYS} />
    </Sheet>
  );
}

export function AboutSheet() {
  const version = useDocument((document) => document.session?.version ?? "");
  return (
    <Sheet title={t("app.name")} testId="about-dialog">
      <p>{t("help.about-text", { version })}</p>
    </Sheet>
  );
}
