/** How the run ended, whole: the toolbar has no room for a long sentence. */
import { Said } from "../../i18n/Said";
import { isEnded, useRun } from "../../session/run";

export function Ending() {
  const sentence = useRun((run) => (isEnded(run.status) && !run.real ? run.sentence : ""));
  if (sentence === "") return null;
  return (
    <p className="arena-ending" data-testid="ending">
      <Said text={sentence} />
    </p>
  );
}
