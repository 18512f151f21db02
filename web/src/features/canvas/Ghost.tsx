/** What follows the pointer during a drag. */
import { createPortal } from "react-dom";

import { t } from "../../i18n/words";
import { title } from "../../model/parts";
import { useDrag } from "../../session/drag";
import { useDrawing } from "../../session/drawing";
import { Tile } from "../../theme";

export function Ghost() {
  const payload = useDrag((state) => state.payload);
  const { x, y } = useDrag((state) => state.at);
  const copy = useDrag((state) => state.copy);
  const aside = useDrag((state) => state.target?.place.kind === "void");
  const drawing = useDrawing();
  if (payload === null || drawing === null) return null;
  const shape = drawing.parts.shape(payload.element);
  const many = payload.kind === "vertices" && payload.ids.length > 1 ? ` +${String(payload.ids.length - 1)}` : "";
  return createPortal(
    <div
      className="ghost row nowrap carried"
      style={{ transform: `translate(${String(x + 10)}px, ${String(y + 12)}px)` }}
      data-colour={shape.colour}
    >
      <Tile icon={shape.icon} colour={shape.colour} size={22} />
      <strong>
        {title(shape)}
        {many}
      </strong>
      {copy && payload.kind === "vertices" ? <span className="ghost-plus badge bold">+</span> : null}
      {aside ? <span className="muted">{t("graph.park-here")}</span> : null}
    </div>,
    document.body,
  );
}
