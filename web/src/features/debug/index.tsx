/** The watch: values of variables and sensors over time; breakpoints that the run follows. */
import { DockButton } from "../../components/DockButton";
import { t } from "../../i18n/words";
import { reveal } from "../../session/actions";
import { followBreakpoints } from "../../session/breakpoints";
import { reportError } from "../../session/document";
import type { Feature } from "../../session/features";
import { endAll } from "../../ui/effects";
import { later } from "../../ui/later";
import { takeSamples } from "./samples";

const WatchPanel = later(() => import("./Watch").then((chunk) => chunk.WatchPanel), reportError);

/** The watch's button in the bottom bar. */
function WatchButton() {
  return (
    <DockButton icon="eye" testId="watch-button" panel="watch-panel">
      {t("debug.watch")}
    </DockButton>
  );
}

export const debug: Feature = {
  name: "debug",
  elsewhere: [{ name: "debug.watch", says: "elsewhere.watch", also: "search.watch" }],
  docks: { "watch-panel": WatchPanel },
  slots: { bottom: WatchButton },
  start: () => endAll(followBreakpoints(reveal), takeSamples()),
};
