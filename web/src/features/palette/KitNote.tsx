/** Says that the parts are those of a kit, with the way back to all of them. */
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import { buildWith, useKit } from "../../session/kit";
import { Tool } from "../../ui/Tool";

export function KitNote() {
  const kit = useKit((state) => state.kit);
  if (kit === null) return null;
  return (
    <p className="palette-kit row muted small-text rigid between" data-testid="palette-kit">
      <span className="ellipsis">{t("kits.parts-of", { name: text(kit.label, kit.name) })}</span>
      <Tool small icon="x" label={t("kits.all-parts")} testId="palette-all-parts" onClick={() => buildWith(null)} />
    </p>
  );
}
