/** Out, how much, in, everything: the small box in the corner. */
import { useStore } from "@xyflow/react";

import { Icon } from "../theme";
import { t } from "../words/words";
import { useView } from "./view";

export function ZoomControl() {
  const zoom = useStore(({ transform }) => Math.round(transform[2] * 100));
  const viewport = useView((state) => state.viewport);
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
    </div>
  );
}
