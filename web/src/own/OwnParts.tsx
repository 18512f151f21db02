/** What lies over the page for parts of one's own: the open sheet, and the menu of a part in the palette. */
import { useState } from "react";

import { complain } from "../shell/document";
import { later } from "../shell/later";
import { FloatingMenu } from "../shell/FloatingMenu";
import { t } from "../words/words";
import { shareParts } from "./share";
import { openDelete, openEdit, useOwn } from "./state";

const OwnSheets = later(() => import("./OwnSheets").then((chunk) => chunk.OwnSheets), complain);

export function OwnParts() {
  const sheet = useOwn((own) => own.sheet);
  const menu = useOwn((own) => own.menu);
  // Its menu stands within the main landmark, as the canvas's does.
  return (
    <>
      {sheet === null ? null : <OwnSheets sheet={sheet} />}
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
        { kind: "item", id: "own-edit", label: t("own.edit"), keys: "F2", run: () => openEdit(name) },
        { kind: "item", id: "own-delete", label: t("own.delete"), keys: "Del", run: () => openDelete(name) },
        { kind: "line", id: "own-1" },
        { kind: "item", id: "own-share", label: t("own.share"), run: () => void shareParts() },
      ]}
      onLeave={() => useOwn.setState({ menu: null })}
      onClose={() => {
        useOwn.setState({ menu: null });
        if (before instanceof HTMLElement) before.focus();
      }}
    />
  );
}
