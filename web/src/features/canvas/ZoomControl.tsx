/** Out, how much, in, everything: the small box in the corner. */
import { t } from "../../i18n/words";
import { keyFor } from "../../session/key-table";
import { follows, toggleFollowing, toggleMinimap, useView } from "../../session/view";
import { Tool } from "../../ui/Tool";
import { useCameraState } from "./camera";

export function ZoomControl() {
  const zoom = useCameraState((state) => Math.round(state.zoom * 100));
  const viewport = useView((state) => state.viewport);
  const minimap = useView((state) => state.minimap);
  const following = useView(follows);
  return (
    <div className="zoom surface aligned" role="group" aria-label={t("graph.zoom")}>
      <Tool icon="minus" label={t("graph.zoom-out")} onClick={viewport?.zoomOut} />
      <button type="button" className="tool zoom-percent" title={t("graph.zoom-actual")} onClick={viewport?.home}>
        {zoom} %
      </button>
      <Tool icon="plus" label={t("graph.zoom-in")} onClick={viewport?.zoomIn} />
      <span className="tool-line" />
      <Tool icon="maximize" label={t("graph.fit")} onClick={viewport?.fit} />
      <span className="tool-line" />
      <Tool
        icon="map"
        label={t("graph.minimap")}
        keys="M"
        aria-pressed={minimap}
        testId="minimap-button"
        onClick={toggleMinimap}
      />
      <Tool
        icon="crosshair"
        label={t("graph.follow")}
        keys={keyFor.graph("follow")}
        aria-pressed={following}
        testId="follow-button"
        onClick={toggleFollowing}
      />
    </div>
  );
}
