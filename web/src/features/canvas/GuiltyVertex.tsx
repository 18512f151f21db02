/** On a vertex at which a property is broken: a cross at its corner, ∞ and the robot, and a sentence above or beside it. */
import "./guilty.css";

import { type CSSProperties, useEffect, useRef, useState } from "react";

import { grouped } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { shortName } from "../../model/short-name";
import type { CounterexampleMark } from "../../session/counterexample";
import { Icon } from "../../theme";

const SHOWN_STEPS = 3;

export function GuiltyVertex({ mark }: { mark: CounterexampleMark }) {
  const { sentence, robots, repeats, steps } = mark;
  const names = robots.map(shortName).join(" ");
  const last = steps.slice(-SHOWN_STEPS).map((step) => grouped(step));
  return (
    <>
      {robots.length === 0 ? null : (
        <span className="guilty-cross badge" data-testid={`guilty-${mark.vertex}`}>
          <Icon name="x" size={14} label={t("guilty.broken")} />
        </span>
      )}
      <span className="guilty-pills flex gap-xs">
        {repeats && names !== "" ? (
          <span
            className="guilty-pill row nowrap gap-xs"
            data-ink=""
            title={t("guilty.repeats", { robots: robots.join(", ") })}
          >
            <Icon name="infinity" size={12} label={t("guilty.repeats", { robots: robots.join(", ") })} />
            <bdi>{names}</bdi>
          </span>
        ) : null}
        {last.length === 0 ? null : (
          <span className="guilty-pill row nowrap gap-xs" title={t("guilty.steps", { steps: last.join(", ") })}>
            {last.join(" ")}
          </span>
        )}
      </span>
      {sentence === "" ? null : <Bubble text={sentence} />}
    </>
  );
}

/** How much of it must be in view, in parts: at each it is looked whether it can be brought in. */
const SHARES = [0.1, 0.25, 0.5, 0.75, 0.9, 1];

/** It stands above the vertex, as far to the left or right as it is in view; beside it where above is no room. */
function Bubble({ text }: { text: string }) {
  const bubble = useRef<HTMLSpanElement>(null);
  const [side, setSide] = useState<"above" | "before" | "behind">("above");
  const [shift, setShift] = useState(0);
  useEffect(() => {
    const shown = bubble.current;
    const root = shown?.closest(".canvas-pane");
    if (side !== "above" || shown == null || root == null) return;
    const observer = new IntersectionObserver(
      ([entry]) => {
        if (entry === undefined || entry.intersectionRatio === 0 || entry.intersectionRatio === 1) return;
        const canvas = root.getBoundingClientRect();
        const now = shown.getBoundingClientRect();
        const node = shown.parentElement?.getBoundingClientRect() ?? now;
        if (now.top < canvas.top && node.top > canvas.top) {
          setSide(node.left - canvas.left > canvas.right - node.right ? "before" : "behind");
        } else {
          const over = Math.max(0, now.right - canvas.right) - Math.max(0, canvas.left - now.left);
          setShift((before) => before - (over * shown.offsetWidth) / now.width);
        }
      },
      { root, threshold: SHARES },
    );
    observer.observe(shown);
    return () => observer.disconnect();
  }, [side]);
  return (
    <span
      className="guilty-bubble surface flex gap-m passive"
      data-side={side}
      style={{ "--shift": `${String(shift)}px` } as CSSProperties}
      ref={bubble}
      role="note"
      data-testid="guilty-sentence"
    >
      <Icon name="x" size={16} />
      <span>
        <Said text={text} />
      </span>
    </span>
  );
}
