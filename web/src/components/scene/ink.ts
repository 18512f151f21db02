/** A path that was begun, filled or drawn along. */
type Pen = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

export function fillWith(pen: Pen, colour: string): void {
  pen.fillStyle = colour;
  pen.fill();
}

/** `width` in px of the canvas, as it is scaled. */
export function strokeWith(pen: Pen, colour: string, width: number): void {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.stroke();
}
