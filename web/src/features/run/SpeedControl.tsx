/** How fast the run goes: a logarithmic slider whose last notch is "as fast as it goes". */
import { mirrored } from "../../i18n/language";
import { t } from "../../i18n/words";
import { nextSpeed } from "../../session/actions";
import { useRun } from "../../session/run";
import { Icon } from "../../theme";
import { MAX_POSITION, positionOf, speedAt } from "./speed";

export function speedWords(speed: number): string {
  return speed === 0 ? t("run.max") : t("run.times", { factor: speed });
}

export function SpeedControl() {
  const speed = useRun((run) => run.speed);
  const setSpeed = useRun((run) => run.setSpeed);
  const watching = useRun((run) => run.watching);
  const position = positionOf(speed);
  return (
    <div className="speed muted rigid inline-row" data-fold={6} title={t("run.speed")}>
      <Icon name="gauge" size={16} />
      <input
        className="slider"
        type="range"
        min={0}
        max={MAX_POSITION}
        step={1}
        value={position}
        disabled={watching}
        style={{ "--share": position / MAX_POSITION } as React.CSSProperties}
        aria-label={t("run.speed")}
        aria-valuetext={speed === 0 ? t("run.as-fast") : speedWords(speed)}
        data-testid="speed"
        onChange={(event) => setSpeed(speedAt(event.target.valueAsNumber))}
        onKeyDown={(event) => {
          // One key press is one round speed: a notch of the slider is less than the eye or the run can tell.
          const faster = mirrored() ? "ArrowLeft" : "ArrowRight";
          const slower = mirrored() ? "ArrowRight" : "ArrowLeft";
          const by = ({ [faster]: 1, ArrowUp: 1, [slower]: -1, ArrowDown: -1 } as Record<string, 1 | -1>)[event.key];
          if (by === undefined) return;
          event.preventDefault();
          setSpeed(nextSpeed(speed, by));
        }}
        onDoubleClick={() => setSpeed(1)}
      />
      <span className="speed-value bold">{speedWords(speed)}</span>
    </div>
  );
}
