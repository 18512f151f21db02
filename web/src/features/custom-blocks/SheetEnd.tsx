/** The end of a sheet about a part of one's own: why it cannot be kept as it is, and the two ways out. */
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { closeSheet } from "../../session/custom-blocks";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";

interface SheetEndProps {
  /** "" when nothing stands in the way. */
  why: string;
  /** What keeping it is called. */
  keep: string;
  disabled: boolean;
}

export function SheetEnd({ why, keep, disabled }: SheetEndProps) {
  return (
    <>
      <p className="own-failure row small-text gap-s" role="status" data-testid="own-failure">
        {why === "" ? null : (
          <>
            <Icon name="triangle-alert" size={16} /> <Said text={why} />
          </>
        )}
      </p>
      <div className="sheet-foot flex gap-m justify-end">
        <Button onClick={closeSheet}>{t("open.cancel")}</Button>
        <Button ink type="submit" testId="own-save" disabled={disabled}>
          {keep}
        </Button>
      </div>
    </>
  );
}
