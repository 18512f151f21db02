/** Duplicates and deletes what is selected. */
import { t } from "../../i18n/words";
import { deleteSelection, duplicateSelection } from "../../session/edits";
import { Icon } from "../../theme";

export function Tools() {
  return (
    <span className="inspector-tools">
      <Tool icon="copy" label={t("inspector.duplicate")} run={duplicateSelection} />
      <Tool icon="trash-2" label={t("inspector.delete")} run={deleteSelection} />
    </span>
  );
}

function Tool({ icon, label, run }: { icon: string; label: string; run: () => void }) {
  return (
    <button type="button" aria-label={label} title={label} onClick={run}>
      <Icon name={icon} size={18} />
    </button>
  );
}
