/** The watch's button in the bottom bar. */
import { DockButton } from "../../components/DockButton";
import { t } from "../../i18n/words";

export function WatchButton() {
  return (
    <DockButton icon="eye" testId="watch-button" panel="watch-panel">
      {t("debug.watch")}
    </DockButton>
  );
}
