/** The keys of the robot that is watched, as buttons that are held: for fingers, keyboards and screen readers. */
import "./hands.css";

import { canInterfere, isLive, useRun } from "../run/run";
import { t } from "../words/words";
import type { HandKey } from "./boards";
import { isHeld, press, release, useHands } from "./hands";

export function Hands({ agent, keys }: { agent: string; keys: readonly HandKey[] }) {
  const live = useRun((run) => canInterfere(run) && isLive(run.status));
  return (
    <div className="arena-hands" role="group" aria-label={t("arena.hands", { name: agent })} data-testid="hands">
      {keys.map((key) => (
        <Key key={key.sensor} agent={agent} of={key} live={live} />
      ))}
      {live ? null : <span className="arena-hands-note">{t("harm.needs-run")}</span>}
    </div>
  );
}

function Key({ agent, of: { sensor, label, letter, pressed }, live }: { agent: string; of: HandKey; live: boolean }) {
  const held = useHands((hands) => isHeld(hands.held, agent, sensor));
  const let_ = () => release(agent, sensor);
  return (
    <button
      type="button"
      className="arena-hand"
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
