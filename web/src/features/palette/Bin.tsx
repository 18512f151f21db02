/** While parts of the graph are dragged: what is dropped on the list of parts is thrown away. */
import { t } from "../../i18n/words";
import { useDrag } from "../../session/drag";
import { Icon } from "../../theme";

export function Bin() {
  const open = useDrag(({ payload }) => payload?.kind === "vertices");
  const away = useDrag((drag) => drag.away);
  if (!open) return null;
  return (
    <div
      className="palette-bin column bold muted justify-centre text-centre"
      data-away={away}
      data-testid="parts-bin"
      aria-hidden="true"
    >
      <Icon name="trash-2" size={24} />
      {t("parts.throw-away")}
    </div>
  );
}
