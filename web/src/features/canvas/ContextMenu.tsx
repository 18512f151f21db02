/** The open menu of the canvas. */
import { useState } from "react";

import { t } from "../../i18n/words";
import type { Point } from "../../model/layout";
import { closeCanvasMenu, useView } from "../../session/view";
import { FloatingMenu } from "../../ui/FloatingMenu";
import { contextEntries } from "./context-entries";

export function ContextMenu() {
  const at = useView((state) => state.menu);
  return at === null ? null : <Open key={`${String(at.x)} ${String(at.y)}`} at={at} />;
}

function Open({ at }: { at: Point }) {
  const [entries] = useState(contextEntries);
  return (
    <FloatingMenu
      id="context"
      label={t("context.title")}
      at={at}
      entries={entries}
      onLeave={closeCanvasMenu}
      onClose={() => {
        closeCanvasMenu();
        useView.getState().viewport?.focus();
      }}
    />
  );
}
