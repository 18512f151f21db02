/** Paper that falls when a run reaches its goal: 20 pieces of 8 px in 900 ms, which lie until the next run. */
import type { Brush } from "../../../components/scene/draw-world";
import { fillWith, strokeWith } from "../../../components/scene/ink";
import { DRIVING, LIDS } from "../../../components/scene/lids";
import type { RunState } from "../../../session/run";

const [PIECES, PIECE_PX, FALL_MS] = [20, 8, 900];

/** Whether a run stands at its end, and that was what the mission wants. */
export function reachedGoal({ status, mission, total }: Pick<RunState, "status" | "mission" | "total">): boolean {
  return status === "done" && (total > 0 || (mission?.goals.length ?? 0) > 0);
}

/** A number from 0 to 1 that is the same for the same piece. */
function share(piece: number, salt: number): number {
  const wave = Math.sin(piece * 127.1 + salt * 311.7) * 43758.5453;
  return wave - Math.floor(wave);
}

export class Confetti {
  private since: number | null = null;
  private readonly again: () => void;

  /** `again`: asks for another picture. */
  constructor(again: () => void) {
    this.again = again;
  }

  begin(): void {
    if (this.since !== null || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    this.since = performance.now();
    this.again();
  }

  clear(): void {
    if (this.since === null) return;
    this.since = null;
    this.again();
  }

  /** Draws them as they are now; true while they fall. */
  draw({ pen, room, colours }: Brush): boolean {
    if (this.since === null) return false;
    const time = Math.min((performance.now() - this.since) / FALL_MS, 1);
    for (let piece = 0; piece < PIECES; piece++) {
      const fall = Math.min(1, time * (1 + share(piece, 1) * 0.4));
      const x = room.width * (0.06 + 0.88 * share(piece, 2)) + Math.sin(time * 6 + piece) * 10 * (1 - fall);
      const y = room.height * (0.05 + 0.85 * share(piece, 3)) * fall;
      pen.save();
      pen.translate(x, y);
      pen.rotate(share(piece, 4) * 6 + (1 - fall) * 5);
      pen.beginPath();
      if (piece % 3 === 0) pen.arc(0, 0, PIECE_PX / 2, 0, Math.PI * 2);
      else pen.rect(-PIECE_PX / 2, -PIECE_PX / 3, PIECE_PX, (PIECE_PX * 2) / 3);
      fillWith(pen, LIDS[piece % DRIVING]?.fill ?? colours.box);
      strokeWith(pen, colours.robotLine, 1);
      pen.restore();
    }
    return time < 1;
  }
}
