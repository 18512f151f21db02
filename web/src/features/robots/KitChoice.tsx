/** What a robot is built of, as its card says it, with the way to say another kit. */
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { kitFor, knowsKit, useBoards } from "./boards";
import { FirmwareNeed } from "./Firmware";
import { askKit, useKitsAt } from "./kits";
import { Button } from "../../ui/Button";

interface KitProps {
  address: string;
  disabled: boolean;
  /** The version of MicroPython that the board has, "" where that is not known. */
  has: string;
  /** The page with MicroPython for the board, "" where none is known. */
  page: string;
}

export function KitChoice({ address, disabled, has, page }: KitProps) {
  const kits = useKitsAt(useStudio((studio) => studio.file.path));
  const state = useBoards();
  const chosen = kitFor(state, address);
  const kit = kits?.find(({ name }) => name === chosen);
  const own = t(knowsKit(state, address) ? "boards.kit-own" : "kits.unsaid");
  const name = chosen === "" ? own : text(kit?.label ?? {}, chosen);
  return (
    <>
      <p className="robot-program row muted below">
        <span>{t("boards.kit")}</span>
        <strong title={text(kit?.help ?? {})}>{name}</strong>
        <Button
          testId="robot-kit"
          data-kit={chosen}
          disabled={disabled}
          aria-label={t("kits.change-from", { name })}
          aria-haspopup="dialog"
          onClick={() => askKit(address)}
        >
          {t("kits.change")}
        </Button>
      </p>
      {kit === undefined ? null : <FirmwareNeed kit={kit} has={has} page={page} />}
    </>
  );
}
