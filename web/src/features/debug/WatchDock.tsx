/** The watch's button in the bottom bar, and its place above; the watch itself is fetched when it is first opened. */
import { t } from "../../i18n/words";
import { complain } from "../../session/document";
import { useWatch } from "../../session/watching";
import { DockButton } from "../../ui/DockButton";
import { later } from "../../ui/later";

const WatchPanel = later(() => import("./Watch").then((chunk) => chunk.WatchPanel), complain);

export function WatchButton() {
  const open = useWatch((state) => state.open);
  return (
    <DockButton
      icon="eye"
      testId="watch-button"
      open={open}
      panel="watch-panel"
      onPress={() => useWatch.getState().show(!open)}
    >
      {t("debug.watch")}
    </DockButton>
  );
}

export function WatchDock() {
  const open = useWatch((state) => state.open);
  return open ? <WatchPanel /> : null;
}
