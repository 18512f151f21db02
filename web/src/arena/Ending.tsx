/** How the run ended, whole: the toolbar has no room for a long sentence. */
import { isEnded, useRun } from "../run/run";
import { Said } from "../words/Said";

export function Ending() {
  const sentence = useRun((run) => (isEnded(run.status) && !run.real ? run.sentence : ""));
  if (sentence === "") return null;
  return (
    <p className="arena-ending" data-testid="ending">
      <Said text={sentence} />
    </p>
  );
}
