/** The watch's button in the bottom bar, and its place above; the watch itself is fetched when it is first opened. */
import { complain } from "../shell/document";
import { later } from "../shell/later";
import { Icon } from "../theme";
import { t } from "../words/words";
import { useWatch } from "./watching";

const WatchPanel = later(() => import("./Watch").then((chunk) => chunk.WatchPanel), complain);

export function WatchButton() {
  const open = useWatch((state) => state.open);
  return (
    <button
      type="button"
      className="problems-button"
      data-testid="watch-button"
      aria-expanded={open}
      aria-controls="watch-panel"
      onClick={() => useWatch.getState().show(!open)}
    >
      <Icon name="eye" size={16} />
      {t("debug.watch")}
    </button>
  );
}

export function WatchDock() {
  const open = useWatch((state) => state.open);
  return open ? <WatchPanel /> : null;
}
