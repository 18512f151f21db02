/** Keeps what the pens of the run drew so far as a file. */
import { strokesOfRun } from "../../../components/scene/pen-strokes";
import { drawnByPens } from "../../../session/pen-marks";
import { posesAt } from "../../../session/poses";
import { useRun } from "../../../session/run";
import { download } from "../../../ui/download";
import { drawingSvg } from "./drawing-svg";

export function hasDrawn(): boolean {
  return drawnByPens().marks.length > 0;
}

export function saveDrawing(floor: boolean): void {
  const { world, name } = useRun.getState();
  if (world === null) return;
  const strokes = strokesOfRun(posesAt(performance.now(), false)?.poses ?? []);
  download(`${name || "drawing"}.svg`, drawingSvg(strokes, world, floor), "image/svg+xml");
}
