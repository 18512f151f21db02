/** The button at the end of a part's row that opens its menu; keys open it from the row itself. */
import { Icon } from "../theme";
import { t } from "../words/words";
import { openPartMenu } from "./state";

export function OwnMore({ name }: { name: string }) {
  return (
    <button
      type="button"
      className="own-more"
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
