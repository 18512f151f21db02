/** What a person works on the robot that is watched: buttons that are held, and sliders; for fingers, keyboards and screen readers. */
import "./hands.css";

import { useState } from "react";

import { can, isLive, useRun } from "../../session/run";
import { t } from "../../i18n/words";
import type { HandKey, Slider } from "../../components/scene/boards";
import { isHeld, press, release, useHands } from "../../components/scene/hands";

interface HandsProps {
  agent: string;
  keys: readonly HandKey[];
  sliders: readonly Slider[];
}

export function Hands({ agent, keys, sliders }: HandsProps) {
  const live = useRun((run) => can("force", run) && isLive(run.status));
  return (
    <div
      className="arena-hands row wrap rigid"
      role="group"
      aria-label={t("arena.hands", { name: agent })}
      data-testid="hands"
    >
      {keys.map((key) => (
        <Key key={key.sensor} agent={agent} of={key} live={live} />
      ))}
      {sliders.map((slider) => (
        <Range key={slider.sensor} agent={agent} of={slider} live={live} />
      ))}
      {live ? null : <span className="muted small-text">{t("harm.needs-run")}</span>}
    </div>
  );
}

/** Shows the number that was set until the run's next message, so that the thumb stays under the finger. */
function Range({ agent, of: { sensor, label, value, min, max }, live }: { agent: string; of: Slider; live: boolean }) {
  const force = useRun((run) => run.force);
  const [set, setSet] = useState<{ from: number; to: number } | null>(null);
  const shown = set !== null && set.from === value ? set.to : value;
  return (
    <label className="arena-slider row bold">
      {label}
      <input
        type="range"
        data-testid={`hand-${sensor}`}
        {...{ min, max, value: shown, disabled: !live }}
        onChange={(event) => {
          const to = event.target.valueAsNumber;
          setSet({ from: value, to });
          force(agent, sensor, to);
        }}
      />
      <output>{shown}</output>
    </label>
  );
}

function Key({ agent, of: { sensor, label, letter, pressed }, live }: { agent: string; of: HandKey; live: boolean }) {
  const held = useHands((hands) => isHeld(hands.held, agent, sensor));
  const let_ = () => release(agent, sensor);
  return (
    <button
      type="button"
      className="arena-hand row bold framed"
      data-testid={`hand-${sensor}`}
      aria-pressed={held || pressed}
      disabled={!live}
      title={t("arena.hold", { name: label })}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        press(agent, sensor);
      }}
      onPointerUp={let_}
      onPointerCancel={let_}
      onLostPointerCapture={let_}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if (event.key !== " " && event.key !== "Enter") return;
        event.preventDefault();
        if (!event.repeat) press(agent, sensor);
      }}
      onKeyUp={(event) => {
        if (event.key !== " " && event.key !== "Enter") return;
        event.preventDefault();
        let_();
      }}
      onBlur={let_}
      onClick={(event) => {
        // Neither a pointer nor a key: a screen reader or a voice. A press as short as can be.
        if (event.detail !== 0) return;
        press(agent, sensor);
        let_();
      }}
    >
      {label}
      {letter === "" ? null : <kbd>{letter}</kbd>}
    </button>
  );
}
