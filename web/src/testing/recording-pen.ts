/** A pen of a canvas that keeps what it is asked to draw, with the style that it has then: jsdom has no canvas. */
import type { Camera, Room } from "../components/scene/camera";
import type { Colours } from "../components/scene/colours";
import type { Brush } from "../components/scene/draw-world";

/** What was filled or stroked: the style, and the steps of the path in whole px. */
export interface Asked {
  what: "fill" | "stroke";
  colour: string;
  width: number;
  /** "evenodd" where it is filled so. */
  rule: string;
  /** [name, ...numbers] of each step since the path began. */
  path: readonly (readonly [string, ...number[]])[];
}

export interface Recording {
  brush: Brush;
  asked: Asked[];
  /** Words that were written. */
  words: string[];
}

const MADE_OF = new Set(["moveTo", "lineTo", "arc", "rect", "roundRect"]);
/** Sets the pen on another place; the steps of a path after it count from there. */
const MOVES = new Set(["translate"]);

/** A brush whose colours are their own names. */
export function recordingBrush(camera: Camera, room: Room): Recording {
  const asked: Asked[] = [];
  const words: string[] = [];
  const style: Record<string, unknown> = { lineWidth: 1, fillStyle: "", strokeStyle: "" };
  let path: [string, ...number[]][] = [];
  const keep = (what: Asked["what"], rule: unknown) => {
    const colour = String(style[what === "fill" ? "fillStyle" : "strokeStyle"]);
    asked.push({
      what,
      colour,
      width: Number(style["lineWidth"]),
      rule: typeof rule === "string" ? rule : "",
      path: [...path],
    });
  };
  const pen = new Proxy(style, {
    get: (target, name: string) => {
      if (name in target) return target[name];
      if (name === "beginPath") return () => (path = path.filter(([step]) => MOVES.has(step)));
      if (name === "restore") return () => (path = []);
      if (name === "fill" || name === "stroke") return (rule: unknown) => keep(name, rule);
      if (name === "fillText") return (said: string) => words.push(said);
      if (name === "measureText") return (said: string) => ({ width: 8 * said.length });
      if (MADE_OF.has(name) || MOVES.has(name))
        return (...numbers: number[]) => path.push([name, ...numbers.map((one) => Math.round(one))]);
      return () => undefined;
    },
  }) as unknown as CanvasRenderingContext2D;
  const colours = new Proxy({}, { get: (_, name) => String(name) }) as Colours;
  return { brush: { pen, camera, room, unit: 1, colours }, asked, words };
}
