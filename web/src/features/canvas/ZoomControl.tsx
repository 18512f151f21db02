/** Out, how much, in, everything: the small box in the corner. */
import { t } from "../../i18n/words";
import { keyFor } from "../../session/key-table";
import { follows, toggleFollowing, toggleMinimap, useView } from "../../session/view";
import { Icon } from "../../theme";
import { useCameraState } from "./camera";

export function ZoomControl() {
  const zoom = useCameraState((state) => Math.round(state.zoom * 100));
  const viewport = useView((state) => state.viewport);
  const minimap = useView((state) => state.minimap);
  const following = useView(follows);
  return (
    <div className="zoom" role="group" aria-label={t("graph.zoom")}>
      <button type="button" aria-label={t("graph.zoom-out")} title={t("graph.zoom-out")} onClick={viewport?.zoomOut}>
        <Icon name="minus" />
      </button>
      <button type="button" className="zoom-percent" title={t("graph.zoom-actual")} onClick={viewport?.home}>
        {zoom} %
      </button>
      <button type="button" aria-label={t("graph.zoom-in")} title={t("graph.zoom-in")} onClick={viewport?.zoomIn}>
        <Icon name="plus" />
      </button>
      <span className="zoom-line" />
      <button type="button" aria-label={t("graph.fit")} title={t("graph.fit")} onClick={viewport?.fit}>
        <Icon name="maximize" />
      </button>
      <span className="zoom-line" />
      <button
        type="button"
        aria-label={t("graph.minimap")}
        aria-pressed={minimap}
        title={`${t("graph.minimap")} · M`}
        data-testid="minimap-button"
        onClick={toggleMinimap}
      >
        <Icon name="map" />
      </button>
      <button
        type="button"
        aria-label={t("graph.follow")}
        aria-pressed={following}
        title={`${t("graph.follow")} · ${keyFor.graph("follow")}`}
        data-testid="follow-button"
        onClick={toggleFollowing}
      >
        <Icon name="crosshair" />
      </button>
    </div>
  );
}
