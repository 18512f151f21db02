/** Duplicates and deletes what is selected. */
import { t } from "../../i18n/words";
import { deleteSelection, duplicateSelection } from "../../session/edits";
import { Tool } from "../../ui/Tool";

export function Tools() {
  return (
    <span className="muted flex to-end gap-2xs">
      <Tool small icon="copy" label={t("inspector.duplicate")} onClick={duplicateSelection} />
      <Tool small icon="trash-2" label={t("inspector.delete")} onClick={deleteSelection} />
    </span>
  );
}
