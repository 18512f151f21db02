/** What the canvas has to say about the last thing that was tried: a sentence, gone at the next change. */
import { useEffect } from "react";

import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { sayOnCanvas, useView } from "../../session/view";
import { Icon } from "../../theme";
import { Tool } from "../../ui/Tool";

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
    <div className="said surface row" role="status" data-testid="said" hidden={said === ""}>
      <Icon name="info" size={16} />
      <span>{said}</span>
      <Tool small icon="x" label={t("graph.close")} onClick={() => sayOnCanvas("")} />
    </div>
  );
}
