/**
 * The tools under the menus: undo and redo, those of the features, what the run is doing; STOP at the end.
 *
 * Tools without room give way in the order of their `fold`; a menu at the end has them all.
 */
import { useRef } from "react";

import { Slot } from "../components/Slot";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { features, STOP_KEY, stopEverything } from "../session/features";
import { keyFor } from "../session/key-table";
import { Icon } from "../theme";
import { useFolding } from "../ui/folding";
import { isItem, type MenuPart } from "../ui/menu-model";
import { MenuButton } from "../ui/MenuButton";
import { Tool } from "../ui/Tool";
import { KEYS } from "./page-keys";

/** What the tools do, from the menus, which say it in words: a menu for those that found no room. */
function MoreTools({ menus }: { menus: MenuPart[] }) {
  const entries = menus
    .flatMap((menu) => menu.entries)
    .filter((entry) => isItem(entry) && /^(edit-(undo|redo)|run-.*|robots-run)$/.test(entry.id));
  return (
    <span data-folded="2">
      <MenuButton
        id="more-tools"
        label={t("tools.more")}
        aria-label={t("tools.more")}
        className="tool rigid"
        entries={entries}
      >
        <Icon name="ellipsis" size={18} />
      </MenuButton>
    </span>
  );
}

export function Toolbar({ menus }: { menus: MenuPart[] }) {
  const tools = useRef<HTMLDivElement>(null);
  useFolding(tools);
  const { canUndo, canRedo, undoLabel, redoLabel } = useStudio();
  const { undo, redo } = useStudio.getState();
  return (
    <div className="toolbar aligned">
      <div className="tools row slim gap-xs" role="toolbar" aria-label={t("menu.run")} ref={tools}>
        <Tool
          icon="undo-2"
          label={undoLabel === "" ? t("edit.undo") : t("edit.undo-what", { what: undoLabel })}
          keys={keyFor.page(KEYS.undo)}
          disabled={!canUndo}
          testId="undo"
          data-fold={9}
          onClick={undo}
        />
        <Tool
          icon="redo-2"
          label={redoLabel === "" ? t("edit.redo") : t("edit.redo-what", { what: redoLabel })}
          keys={keyFor.page(KEYS.redo)}
          disabled={!canRedo}
          testId="redo"
          data-fold={7}
          onClick={redo}
        />
        <span className="tool-line rigid" data-fold={9} />
        <Slot name="tools" />
        <MoreTools menus={menus} />
      </div>
      <Slot name="status" />
    </div>
  );
}

/**
 * Ends the run and with it every robot of the team, from anywhere. It is the one red thing while something runs, and quiet
 * before; it can be pressed at any time, since a board may run that this page does not know of.
 */
export function TeamStop() {
  // The list of features never changes, so neither does the order of their hooks.
  // eslint-disable-next-line react-hooks/rules-of-hooks
  const on = features().map(({ useOn }) => useOn?.() ?? false);
  return (
    <button
      type="button"
      className="team-stop row start-text gap-xl hover framed justify-centre"
      data-on={on.includes(true)}
      data-testid="team-stop"
      title={`${t("stop.label")} (${keyFor.page(STOP_KEY)})`}
      onClick={stopEverything}
    >
      <Icon name="octagon-x" size={24} />
      <span>
        <strong>{t("stop.big")}</strong>
        <small>{t("stop.small")}</small>
      </span>
    </button>
  );
}
