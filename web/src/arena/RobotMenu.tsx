/** The menu of a robot in the arena: by the right button, a finger that rests, the menu key, or Enter on the chosen one. */
import { useEffect, useLayoutEffect, useRef, useState } from "react";
import { createPortal } from "react-dom";

import { FAILED, MUTED, STALLED } from "../api/wire";
import { Menu } from "../shell/Menu";
import type { MenuEntry } from "../shell/menu-model";
import { posesAt } from "../run/poses";
import { canGoBack, useRun } from "../run/run";
import { t } from "../words/words";
import { follow, harm, useRobots } from "./robots";

const EDGE = 8;

export function RobotMenu({ onClosed }: { onClosed: () => void }) {
  const menu = useRobots((state) => state.menu);
  const place = document.querySelector("main") ?? document.body;
  if (menu === null) return null;
  return createPortal(<Open key={`${menu.name} ${String(menu.x)}`} {...menu} onClosed={onClosed} />, place);
}

/** What can be done to a robot as it is now. */
export function entriesOf(name: string): MenuEntry[] {
  const run = useRun.getState();
  const on = canGoBack(run.status) && !run.recording;
  const index = run.agents.findIndex((agent) => agent.name === name);
  const flags = posesAt(0, false)?.poses[index]?.flags ?? 0;
  const isDown = (flags & (FAILED | STALLED)) !== 0;
  const isMuted = (flags & MUTED) !== 0;
  const { followed } = useRobots.getState();
  return [
    ...(on ? [] : [{ kind: "heading", id: "harm-needs-run", label: t("harm.needs-run") } as const]),
    {
      kind: "item",
      id: "harm-fail",
      label: t("harm.fail"),
      disabled: !on || (flags & FAILED) !== 0,
      run: () => harm(name, "fail"),
    },
    { kind: "item", id: "harm-stall", label: t("harm.stall"), disabled: !on || isDown, run: () => harm(name, "stall") },
    { kind: "item", id: "harm-mute", label: t("harm.mute"), disabled: !on || isMuted, run: () => harm(name, "mute") },
    {
      kind: "item",
      id: "harm-revive",
      label: t("harm.revive"),
      disabled: !on || !(isDown || isMuted),
      run: () => harm(name, "revive"),
    },
    { kind: "line", id: "harm-1" },
    { kind: "check", id: "harm-follow", label: t("harm.follow"), checked: followed === name, run: () => follow(name) },
  ];
}

function Open({ name, x, y, onClosed }: { name: string; x: number; y: number; onClosed: () => void }) {
  const root = useRef<HTMLDivElement>(null);
  const [entries] = useState(() => entriesOf(name));
  const [place, setPlace] = useState({ x, y });
  useLayoutEffect(() => {
    const box = root.current?.querySelector("[role=menu]")?.getBoundingClientRect();
    if (box === undefined) return;
    setPlace({
      x: Math.max(EDGE, Math.min(x, window.innerWidth - EDGE - box.width)),
      y: Math.max(EDGE, Math.min(y, window.innerHeight - EDGE - box.height)),
    });
  }, [x, y]);
  useEffect(() => {
    const outside = (event: Event) => {
      if (event.target instanceof Node && root.current?.contains(event.target) === true) return;
      useRobots.setState({ menu: null });
    };
    document.addEventListener("pointerdown", outside, true);
    document.addEventListener("wheel", outside, true);
    window.addEventListener("blur", outside);
    return () => {
      document.removeEventListener("pointerdown", outside, true);
      document.removeEventListener("wheel", outside, true);
      window.removeEventListener("blur", outside);
    };
  }, []);
  return (
    <div
      ref={root}
      className="context-menu"
      data-testid="robot-menu"
      style={{ transform: `translate(${String(place.x)}px, ${String(place.y)}px)` }}
      onContextMenu={(event) => event.preventDefault()}
    >
      <Menu
        id="robot-menu-list"
        label={t("harm.menu", { name })}
        entries={entries}
        onClose={() => {
          useRobots.setState({ menu: null });
          onClosed();
        }}
      />
    </div>
  );
}
