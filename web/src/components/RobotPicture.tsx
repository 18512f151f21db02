/** A robot in a small picture, with the body and the face that it has in the arena; a board without wheels with its lights. */
import "./robot-picture.css";

import { useMemo } from "react";

import { readColours } from "./scene/colours";
import { drawFigure } from "./scene/figures";
import { DRIVING, STONE, SUN } from "./scene/lids";
import { useStudio } from "../model/studio";
import { useTheme } from "../theme";

/** Units of a figure's picture, from edge to edge, and pixels of one. */
const [ACROSS, PIXELS] = [76, 4];
/** The length of a robot of 135 mm in these units. */
const LENGTH = 54;

interface RobotProps {
  kind: string;
  /** Its place among others, by which it has its colour. */
  index: number;
  x: number;
  y: number;
  /** In radians, against the clock. */
  heading: number;
  /** In units of the picture. */
  length: number;
}

const LIDS_OF: Readonly<Record<string, number>> = { loader: SUN, unloader: SUN, "store-manager": STONE };

function useFigure(figure: string, index: number): string {
  return useMemo(() => {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = ACROSS * PIXELS;
    const pen = canvas.getContext("2d");
    if (pen === null) return "";
    pen.translate(canvas.width / 2, canvas.height / 2);
    const lid = LIDS_OF[figure] ?? index % DRIVING;
    drawFigure(pen, PIXELS, { figure, lid, load: 0, lamp: false, face: "open", out: false }, readColours());
    return canvas.toDataURL();
  }, [figure, index]);
}

function Figure({ figure, index }: { figure: string; index: number }) {
  const from = -ACROSS / 2;
  return <image href={useFigure(figure, index)} x={from} y={from} width={ACROSS} height={ACROSS} />;
}

/** The lights of a board that are lit in its picture: a heart. */
const LIT = "01010 11111 11111 01110 00100".split(" ");

function Board() {
  return (
    <g>
      <rect className="robot-board" x="-27" y="-22" width="54" height="44" rx="5" />
      {LIT.flatMap((row, y) =>
        [...row].map((light, x) => (
          <rect
            key={`${String(x)} ${String(y)}`}
            className={light === "1" ? "robot-light is-lit" : "robot-light"}
            x={(x - 2) * 5 - 1.5}
            y={(y - 2) * 5 - 1.5}
            width="3"
            height="3"
            rx="0.8"
          />
        )),
      )}
    </g>
  );
}

/** A robot alone, seen from above and looking up. */
export function RobotPicture({ kind, index }: Pick<RobotProps, "kind" | "index">) {
  const view = [-ACROSS / 2, -ACROSS / 2, ACROSS, ACROSS].join(" ");
  return (
    <svg className="picture picture-world" viewBox={view} aria-hidden="true">
      <Robot kind={kind} index={index} x={0} y={0} heading={Math.PI / 2} length={LENGTH} />
    </svg>
  );
}

export function Robot({ kind, index, x, y, heading, length }: RobotProps) {
  const robot = useStudio((studio) => studio.catalogue.robots.find((one) => one.name === kind));
  const theme = useTheme((state) => state.theme);
  const figure = robot?.figure ?? "";
  const board = figure === "" || figure === "micro-bit";
  // A board, and who keeps a storehouse, stand upright.
  const turn = board || figure === "store-manager" ? 0 : (-heading * 180) / Math.PI;
  return (
    <g transform={`translate(${String(x)} ${String(y)}) rotate(${String(turn)}) scale(${String(length / LENGTH)})`}>
      {board ? <Board /> : <Figure key={theme} figure={figure} index={index} />}
    </g>
  );
}
