/** Under a small program beside a large arena: the robot that is watched. */
import { useStage } from "../../session/stage";
import { useParts } from "./parts";

export function StageSide() {
  const large = useStage((stage) => stage.large);
  const stage = useParts((parts) => parts.stage);
  return large && stage !== null ? <stage.Watched /> : null;
}
