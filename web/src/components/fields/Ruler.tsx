/** A ruler: a distance from the front of the robot, and what the sensor measures now while a run exists. */
import { type PointerEvent, useRef } from "react";

import { mirrored } from "../../i18n/language";
import { decimal } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { inWords, withUnit } from "../../model/meaning";
import { useStudio } from "../../model/studio";
import type { RobotObject } from "../../model/types";
import { useRun, watchedAgent } from "../../session/run";
import type { ControlProps } from "./FieldRow";
import { sliderProps, within } from "./number-text";

const TICKS = 20;

export function Ruler({ sensor, ...props }: ControlProps & { sensor: RobotObject | null }) {
  const { field, value, set } = props;
  const scale = useRef<HTMLSpanElement>(null);
  const program = useStudio((state) => state.activeProgram);
  const now = useRun((run) => (sensor === null ? undefined : watchedAgent(run, program)?.inputs[sensor.name]));
  const { min, max } = field;
  const share = (number: number) => `${String((100 * (number - min)) / Math.max(1, max - min))}%`;
  const drag = (event: PointerEvent) => {
    const box = scale.current?.getBoundingClientRect();
    if (box === undefined || box.width === 0) return;
    const from = (event.clientX - box.left) / box.width;
    set(within(Math.round(min + (mirrored() ? 1 - from : from) * (max - min)), field));
  };
  return (
    <span
      className="field-ruler column relative"
      {...sliderProps(props, mirrored())}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        drag(event);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) drag(event);
      }}
    >
      <span className="ruler-scale relative" ref={scale}>
        <span className="ruler-share" style={{ inlineSize: share(value) }} />
        {now === undefined ? null : (
          <span className="ruler-now" style={{ inlineSize: share(within(now, field)) }} data-testid="ruler-now">
            <span>{t("graph.now", { value: inWords(field, now) })}</span>
          </span>
        )}
        {Array.from({ length: TICKS + 1 }, (_, tick) => (
          <span
            key={tick}
            className="ruler-tick"
            data-long={tick % 2 === 0}
            style={{ insetInlineStart: `${String((100 * tick) / TICKS)}%` }}
          />
        ))}
        <span className="ruler-handle" style={{ insetInlineStart: share(value) }} />
      </span>
      <span className="field-marks muted flex between nowrap tiny-text" aria-hidden="true">
        <span>{decimal(min * field.scale)}</span>
        <span>{decimal(((min + max) / 2) * field.scale)}</span>
        <span>{withUnit(decimal(max * field.scale), field)}</span>
      </span>
    </span>
  );
}
