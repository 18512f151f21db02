/** Blocks of one's own: saving the selection as one, changing and sharing them. */
import { t } from "../../i18n/words";
import { ownConstructors } from "../../model/own";
import { useStudio } from "../../model/studio";
import { canSave, openSave } from "../../session/custom-blocks";
import type { Feature } from "../../session/features";
import { keyFor } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { menuItem } from "../../ui/menu-model";
import { CustomBlocks } from "./CustomBlocks";
import { shareParts } from "./share";

function useMenu(): MenuEntries {
  const { selection, mission } = useStudio();
  return {
    "custom-blocks": [
      menuItem(
        "program-save-part",
        t("own.save"),
        keyFor.graph("savePart"),
        openSave,
        selection.length === 0 || !canSave(),
      ),
      menuItem("program-share-parts", t("own.share"), null, shareParts, ownConstructors(mission).length === 0),
    ],
  };
}

export const customBlocks: Feature = { name: "custom-blocks", slots: { "over-page": CustomBlocks }, useMenu };
