/** What the canvas has to say about the last thing that was tried: a sentence, gone at the next change. */
import { useEffect } from "react";

import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { sayOnCanvas, useView } from "../../session/view";
import { Icon } from "../../theme";

export function Said() {
  const said = useView((state) => state.said);
  useEffect(
    () =>
      useStudio.subscribe((state, before) => {
        if (state.mission !== before.mission || state.activeProgram !== before.activeProgram) sayOnCanvas("");
      }),
    [],
  );
  return (
    <div className="said" role="status" data-testid="said" hidden={said === ""}>
      <Icon name="info" size={16} />
      <span>{said}</span>
      <button type="button" aria-label={t("graph.close")} title={t("graph.close")} onClick={() => sayOnCanvas("")}>
        <Icon name="x" size={14} />
      </button>
    </div>
  );
}
