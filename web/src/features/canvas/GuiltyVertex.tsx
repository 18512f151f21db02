/** On a vertex at which a property is broken: a cross at its corner, ∞ and the robot, and a sentence above or beside it. */
import { useLayoutEffect, useRef, useState } from "react";

import { grouped } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { shortName } from "../../model/short-name";
import type { GuiltyMark } from "../../session/guilty";
import { Icon } from "../../theme";
import "./guilty.css";

/** Room that the sentence needs between the vertex and the upper edge of the canvas, px. */
const ROOM = 24;
const SHOWN_STEPS = 3;

export function GuiltyVertex({ mark }: { mark: GuiltyMark }) {
  const { sentence, robots, repeats, steps } = mark;
  const names = robots.map(shortName).join(" ");
  const last = steps.slice(-SHOWN_STEPS).map((step) => grouped(step));
  return (
    <>
      {robots.length === 0 ? null : (
        <span className="guilty-cross" data-testid={`guilty-${mark.vertex}`}>
          <Icon name="x" size={14} label={t("guilty.broken")} />
        </span>
      )}
      <span className="guilty-pills">
        {repeats && names !== "" ? (
          <span className="guilty-pill" data-ink="" title={t("guilty.repeats", { robots: robots.join(", ") })}>
            <Icon name="infinity" size={12} label={t("guilty.repeats", { robots: robots.join(", ") })} />
            <bdi>{names}</bdi>
          </span>
        ) : null}
        {last.length === 0 ? null : (
          <span className="guilty-pill" title={t("guilty.steps", { steps: last.join(", ") })}>
            {last.join(" ")}
          </span>
        )}
      </span>
      {sentence === "" ? null : <Bubble text={sentence} />}
    </>
  );
}

/** It stands above the vertex where there is room when it comes, else beside it. */
function Bubble({ text }: { text: string }) {
  const bubble = useRef<HTMLSpanElement>(null);
  const [side, setSide] = useState<"above" | "before" | "behind">("above");
  useLayoutEffect(() => {
    const node = bubble.current?.parentElement?.getBoundingClientRect();
    const canvas = bubble.current?.closest(".react-flow")?.getBoundingClientRect();
    const height = bubble.current?.getBoundingClientRect().height ?? 0;
    if (node === undefined || canvas === undefined || node.top - canvas.top > height + ROOM) return;
    setSide(node.left - canvas.left > canvas.right - node.right ? "before" : "behind");
  }, []);
  return (
    <span className="guilty-bubble" data-side={side} ref={bubble} role="note" data-testid="guilty-sentence">
      <Icon name="x" size={16} />
      <span>
        <Said text={text} />
      </span>
    </span>
  );
}
