/** A dial: an angle, counter-clockwise from straight ahead as the robot turns. Over a full turn it counts rounds. */
import { type PointerEvent, useRef } from "react";

import { t } from "../../i18n/words";
import { inWords } from "../../model/meaning";
import type { ControlProps } from "./FieldRow";
import { sliderProps, within } from "./number-text";

const R = 48;
const SIZE = 124;
const ROBOT = "M-15-19H5A19 19 0 0 1 5 19H-15A12 12 0 0 1-27 7V-7A12 12 0 0 1-15-19Z";
/** Angles that have a button, as far as they are in range and whole steps. */
const USUAL = [45, 72, 90, 135, 144, 180, 270, 360];
const MOST_USUAL = 5;
const NAMED = { 90: "fields.quarter", 180: "fields.half", 270: "fields.three-quarters", 360: "fields.full" } as const;

/** A point of the dial, `degrees` counter-clockwise from the top. */
function at(degrees: number, radius: number): [number, number] {
  const angle = (degrees * Math.PI) / 180;
  return [-Math.sin(angle) * radius, -Math.cos(angle) * radius];
}

function point(degrees: number, radius: number): string {
  return at(degrees, radius)
    .map((one) => one.toFixed(2))
    .join(" ");
}

/** The angle of a point, in degrees from 0 to 360, or in the round that is nearest to `before`. */
export function angleOf(x: number, y: number, before: number): number {
  const angle = ((Math.atan2(-x, -y) * 180) / Math.PI + 360) % 360;
  return angle + 360 * Math.round((before - angle) / 360);
}

/** The angles that have a button: whole steps within the range. */
export function usualAngles({ min, max, scale }: ControlProps["field"]): number[] {
  const whole = (angle: number) => Math.abs(angle / scale - Math.round(angle / scale)) < 1e-9;
  return USUAL.filter((angle) => angle <= max * scale && angle >= min * scale && whole(angle)).slice(0, MOST_USUAL);
}

export function Dial(props: ControlProps) {
  const { field, value, set } = props;
  const face = useRef<SVGSVGElement>(null);
  const degrees = value * field.scale;
  const turned = Math.min(Math.abs(degrees), 359.99) * Math.sign(degrees);
  const drag = (event: PointerEvent) => {
    const box = face.current?.getBoundingClientRect();
    if (box === undefined) return;
    const x = event.clientX - (box.left + box.right) / 2;
    const y = event.clientY - (box.top + box.bottom) / 2;
    set(within(Math.round(angleOf(x, y, degrees) / field.scale), field));
  };
  const name = NAMED[degrees as keyof typeof NAMED] as (typeof NAMED)[keyof typeof NAMED] | undefined;
  const rounds = Math.floor(Math.abs(degrees) / 360);
  const [hx, hy] = at(degrees, R);
  return (
    <span className="field-dial row gap-2xl">
      <svg
        ref={face}
        className="dial rigid"
        width={SIZE}
        height={SIZE}
        viewBox="-62 -62 124 124"
        {...sliderProps(props, false)}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          drag(event);
        }}
        onPointerMove={(event) => {
          if (event.currentTarget.hasPointerCapture(event.pointerId)) drag(event);
        }}
      >
        <circle className="dial-face" r={R} />
        {Array.from({ length: 24 }, (_, tick) => (
          <path
            key={tick}
            className="dial-tick"
            d={`M${point(tick * 15, R - 2)}L${point(tick * 15, tick % 6 === 0 ? R - 10 : R - 6)}`}
          />
        ))}
        <path
          className="dial-share"
          d={`M0 0L0-${String(R)}A${String(R)} ${String(R)} 0 ${Math.abs(turned) > 180 ? "1" : "0"} ${turned < 0 ? "1" : "0"} ${point(turned, R)}Z`}
        />
        <path
          className="dial-arc"
          d={`M0-${String(R)}A${String(R)} ${String(R)} 0 ${Math.abs(turned) > 180 ? "1" : "0"} ${turned < 0 ? "1" : "0"} ${point(turned, R)}`}
        />
        <g transform="rotate(-90) scale(.62)">
          <path className="dial-robot" d={ROBOT} />
          <circle className="dial-eye" cx="18" cy="-9.6" r="7.4" />
          <circle className="dial-eye" cx="18" cy="9.6" r="7.4" />
          <circle cx="20" cy="-9.6" r="3.8" />
          <circle cx="20" cy="9.6" r="3.8" />
        </g>
        <circle className="dial-handle" cx={hx} cy={hy} r="8" />
      </svg>
      <span className="column gap-m grow">
        <span className="muted">
          {name === undefined ? (rounds > 0 ? t("fields.rounds", { count: rounds }) : "") : t(name)}
        </span>
        <span className="field-usual wrap flex gap-s">
          {usualAngles(field).map((angle) => {
            const number = Math.round(angle / field.scale);
            return (
              <button key={angle} type="button" aria-pressed={value === number} onClick={() => set(number)}>
                {inWords(field, number)}
              </button>
            );
          })}
        </span>
      </span>
    </span>
  );
}
