/** Blocks of one's own: saving the selection as one, changing and sharing them. */
import { useState } from "react";

import { t } from "../../i18n/words";
import { ownConstructors } from "../../model/own-parts";
import { useStudio } from "../../model/studio";
import { canSave, closeMenu, openDelete, openEdit, openSave, useOwn } from "../../session/custom-blocks";
import { reportError } from "../../session/document";
import type { Feature } from "../../session/features";
import { keyFor } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { FloatingMenu } from "../../ui/FloatingMenu";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";
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

const CustomBlockSheets = later(
  () => import("./CustomBlockSheets").then((chunk) => chunk.CustomBlockSheets),
  reportError,
);

/** What lies over the page for parts of one's own: the open sheet, and the menu of a part in the palette. */
export function CustomBlocks() {
  const sheet = useOwn((own) => own.sheet);
  const menu = useOwn((own) => own.menu);
  // Its menu stands within the main landmark, as the canvas's does.
  return (
    <>
      {sheet === null ? null : <CustomBlockSheets sheet={sheet} />}
      {menu === null ? null : <PartMenu key={menu.name} {...menu} />}
    </>
  );
}

function PartMenu({ name, x, y }: { name: string; x: number; y: number }) {
  const [before] = useState(() => document.activeElement);
  return (
    <FloatingMenu
      id="own"
      label={t("own.menu", { name })}
      at={{ x, y }}
      entries={[
        menuItem("own-edit", t("own.edit"), "F2", () => openEdit(name)),
        menuItem("own-delete", t("own.delete"), "Del", () => openDelete(name)),
        { kind: "line", id: "own-1" },
        menuItem("own-share", t("own.share"), null, shareParts),
      ]}
      onLeave={closeMenu}
      onClose={() => {
        closeMenu();
        if (before instanceof HTMLElement) before.focus();
      }}
    />
  );
}

export const customBlocks: Feature = { name: "custom-blocks", slots: { "over-page": CustomBlocks }, useMenu };
