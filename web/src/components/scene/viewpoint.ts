/**
 * Where the camera is and where it is going: on what matters (`framing`), on the whole world, or where a hand left it.
 *
 * On its own it stays while what matters is on the screen, comes back with more room when that leaves, and looks closely
 * once a run is over. A hand's view stays until somebody asks for what matters again.
 */
import { type Box, type Camera, fitBox, type Room } from "./camera";
import { atLeast, cameraBetween, isOnScreen } from "./framing";

/** Around what matters, in px; and how much of the world is shown at least, in mm: while something runs, and then. */
const [MARGIN_PX, OPEN_MM, CLOSE_MM] = [20, 1000, 300];
/** What leaves the screen comes back with so much more room. */
const MORE = 1.3;
const EASE_MS = 320;
/** Where the robot that is watched is stands at the lower edge, in px. */
const CAPTION_PX = 28;

interface Sights {
  /** The camera that shows all there is in the part of the canvas that nothing covers. */
  whole: (free: Room) => Camera;
  /** What is to be seen of all that; null for all of it. */
  subject: (free: Room) => Box | null;
}

export class Viewpoint {
  camera: Camera = { scale: 1, x: 0, y: 0 };
  private aim: "subject" | "whole" | "hand" = "subject";
  private way: { to: Camera; from: Camera; since: number } | null = null;
  private open = true;
  private covered = 0;
  private room: Room = { width: 0, height: 0 };
  private readonly sights: Sights;
  private readonly now: () => number;

  constructor(sights: Sights, now: () => number = () => performance.now()) {
    this.sights = sights;
    this.now = now;
  }

  get isCovered(): boolean {
    return this.covered > 0;
  }

  /** The part of the canvas that nothing covers, so many px at its bottom at least. */
  private free(least = 0): Room {
    const { width, height } = this.room;
    return { width, height: Math.max(height - Math.max(this.covered, least), height / 3) };
  }

  private target(subject: Box | null, more = 1): Camera {
    if (subject === null) return this.sights.whole(this.free());
    return fitBox(atLeast(subject, this.open ? OPEN_MM : CLOSE_MM, more), this.free(CAPTION_PX), MARGIN_PX);
  }

  private subject(): Box | null {
    return this.aim === "whole" ? null : this.sights.subject(this.free());
  }

  private go(to: Camera): void {
    this.way = { to, from: this.camera, since: this.now() };
  }

  /** Another place, or another size of the canvas: nothing is seen of the way there. */
  jump(room: Room = this.room): void {
    this.room = room;
    if (this.aim === "hand") return;
    this.camera = this.target(this.subject());
    this.way = null;
  }

  /** Another world: what a hand left is gone with the one before. */
  begin(): void {
    this.aim = "subject";
    this.jump();
  }

  /** A run begins (`open`), or what it did can be looked at whole. */
  setOpen(open: boolean): void {
    this.open = open;
    if (this.aim === "subject") this.go(this.target(this.subject()));
  }

  /** So many px at the bottom of the canvas are covered. */
  setCovered(px: number): void {
    if (px === this.covered) return;
    this.covered = px;
    if (this.aim === "subject") this.go(this.target(this.subject()));
  }

  /** Back to what matters. */
  showSubject(): void {
    this.aim = "subject";
    this.go(this.target(this.subject()));
  }

  /** Back to what matters; asked once more, all there is. */
  showAll(): void {
    this.aim = this.aim === "subject" ? "whole" : "subject";
    this.go(this.target(this.subject()));
  }

  /** A hand takes the camera there. */
  take(camera: Camera): void {
    this.camera = camera;
    this.aim = "hand";
    this.way = null;
  }

  /** `moving`: whether what matters may leave the screen. True while the camera is on its way. */
  step(moving: boolean, smooth: boolean): boolean {
    if (moving && this.aim === "subject") {
      const subject = this.subject();
      const there = this.way?.to ?? this.camera;
      if (subject !== null && !isOnScreen(subject, there, this.free(CAPTION_PX), MARGIN_PX / 2)) {
        this.go(this.target(subject, this.open ? MORE : 1));
      }
    }
    if (this.way === null) return false;
    const { from, to, since } = this.way;
    const share = smooth ? Math.min((this.now() - since) / EASE_MS, 1) : 1;
    this.camera = cameraBetween(from, to, share);
    if (share === 1) this.way = null;
    return share < 1;
  }
}
