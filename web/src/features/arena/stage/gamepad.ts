/** A gamepad holds the keys of the robot that is watched: its first button the first key, and so on; sticks set sliders. */
import { useEffect } from "react";

import { press, release } from "../../../components/scene/hands";
import type { Actor } from "../../../components/scene/scene";
import { can, isLive, useRun } from "../../../session/run";
import { listen } from "../../../ui/effects";

type Pad = Pick<Gamepad, "axes" | "buttons">;

/** A stick that is nearer to its middle than this is let go. */
const LOOSE = 0.15;

/** What changed between two looks at a pad: keys that go down or up, and sliders that go to a number. */
export function changes(
  pad: Pad,
  before: { down: readonly boolean[]; set: readonly (number | null)[] },
  { keys, sliders }: Pick<Actor, "keys" | "sliders">,
): { down: boolean[]; set: (number | null)[]; press: string[]; release: string[]; slide: [string, number][] } {
  const down = keys.map((_, at) => pad.buttons[at]?.pressed === true);
  const set = sliders.map(({ min, max }, at) => {
    const tilt = pad.axes[at] ?? 0;
    if (Math.abs(tilt) < LOOSE) return null;
    return Math.round(min + ((Math.min(Math.max(tilt, -1), 1) + 1) / 2) * (max - min));
  });
  const names = (wanted: (at: number) => boolean) => keys.filter((_, at) => wanted(at)).map(({ sensor }) => sensor);
  return {
    down,
    set,
    press: names((at) => down[at] === true && before.down[at] !== true),
    release: names((at) => down[at] !== true && before.down[at] === true),
    slide: sliders.flatMap(({ sensor }, at): [string, number][] => {
      const value = set[at];
      return value == null || value === before.set[at] ? [] : [[sensor, value]];
    }),
  };
}

export function useGamepad(actor: Actor | undefined): void {
  const name = actor?.name ?? "";
  const works = (actor?.keys.length ?? 0) + (actor?.sliders.length ?? 0) > 0;
  const live = useRun((run) => can("force", run) && isLive(run.status));
  const keys = actor?.keys.map(({ sensor }) => sensor).join() ?? "";
  useEffect(() => {
    if (!works || !live || actor === undefined) return;
    let request = 0;
    let before: { down: boolean[]; set: (number | null)[] } = { down: [], set: [] };
    const look = () => {
      const pad = navigator.getGamepads().find((one) => one !== null);
      if (pad != null) {
        const now = changes(pad, before, actor);
        before = now;
        for (const sensor of now.press) press(name, sensor);
        for (const sensor of now.release) release(name, sensor);
        for (const [sensor, value] of now.slide) useRun.getState().force(name, sensor, value);
      }
      request = requestAnimationFrame(look);
    };
    const begin = () => {
      cancelAnimationFrame(request);
      look();
    };
    // A pad says that it is there when one of its buttons is pressed; until then nothing is looked at.
    const endWaiting = listen(window, { gamepadconnected: begin });
    if (navigator.getGamepads().some((one) => one !== null)) begin();
    return () => {
      endWaiting();
      cancelAnimationFrame(request);
      before.down.forEach((held, at) => {
        const sensor = actor.keys[at]?.sensor;
        if (held && sensor !== undefined) release(name, sensor);
      });
    };
    // The actor is made anew with each message of the run; its keys stay.
    // eslint-disable-next-line react-hooks/exhaustive-deps
  }, [name, keys, works, live]);
}
