/** The button at the end of a part's row that opens its menu; keys open it from the row itself. */
import { t } from "../../i18n/words";
import { openPartMenu } from "../../session/custom-blocks";
import { Icon } from "../../theme";

export function CustomBlockMore({ name }: { name: string }) {
  return (
    <button
      type="button"
      className="own-more tool small muted rigid to-end"
      tabIndex={-1}
      aria-label={t("own.menu", { name })}
      title={t("own.menu", { name })}
      onPointerDown={(event) => {
        event.stopPropagation();
      }}
      onClick={(event) => {
        event.stopPropagation();
        const box = event.currentTarget.getBoundingClientRect();
        openPartMenu(name, box.left, box.bottom);
      }}
    >
      <Icon name="ellipsis" size={16} />
    </button>
  );
}
