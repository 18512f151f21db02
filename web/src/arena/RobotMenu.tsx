/** The menu of a robot in the arena: by the right button, a finger that rests, the menu key, or Enter on the chosen one. */
import { useState } from "react";

import { FAILED, MUTED, STALLED } from "../api/wire";
import { FloatingMenu } from "../shell/FloatingMenu";
import type { MenuEntry } from "../shell/menu-model";
import { posesAt } from "../run/poses";
import { canInterfere, useRun } from "../run/run";
import { t } from "../words/words";
import { follow, harm, useRobots } from "./robots";

export function RobotMenu({ onClosed }: { onClosed: () => void }) {
  const menu = useRobots((state) => state.menu);
  if (menu === null) return null;
  return <Open key={`${menu.name} ${String(menu.x)}`} {...menu} onClosed={onClosed} />;
}

/** What can be done to a robot as it is now. */
export function entriesOf(name: string): MenuEntry[] {
  const run = useRun.getState();
  const on = canInterfere(run);
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
  const [entries] = useState(() => entriesOf(name));
  return (
    <FloatingMenu
      id="robot"
      label={t("harm.menu", { name })}
      at={{ x, y }}
      entries={entries}
      onLeave={() => useRobots.setState({ menu: null })}
      onClose={() => {
        useRobots.setState({ menu: null });
        onClosed();
      }}
    />
  );
}
