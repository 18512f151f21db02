/** The menu of a robot in the arena: by the right button, a finger that rests, the menu key, or Enter on the chosen one. */
import { useMemo } from "react";

import { FAILED, MUTED, STALLED } from "../../api/wire";
import { t } from "../../i18n/words";
import { posesAt } from "../../session/poses";
import { can, useRun } from "../../session/run";
import { FloatingMenu } from "../../ui/FloatingMenu";
import { menuCheck, type MenuEntry, menuItem } from "../../ui/menu-model";
import { closeRobotMenu, follow, injectFault, useRobots } from "./robots";

export function RobotMenu({ onClosed }: { onClosed: () => void }) {
  const menu = useRobots((state) => state.menu);
  if (menu === null) return null;
  return <Open key={`${menu.name} ${String(menu.x)}`} {...menu} onClosed={onClosed} />;
}

/** What can be done to a robot as it is now. */
export function entriesOf(name: string, on: boolean): MenuEntry[] {
  const run = useRun.getState();
  const index = run.agents.findIndex((agent) => agent.name === name);
  const flags = posesAt(0, false)?.poses[index]?.flags ?? 0;
  const isDown = (flags & (FAILED | STALLED)) !== 0;
  const isMuted = (flags & MUTED) !== 0;
  const byRadio = run.mission?.radio != null;
  const { followed } = useRobots.getState();
  return [
    ...(on ? [] : [{ kind: "heading", id: "harm-needs-run", label: t("harm.needs-run") } as const]),
    menuItem("harm-fail", t("harm.fail"), null, () => injectFault(name, "fail"), !on || (flags & FAILED) !== 0),
    menuItem("harm-stall", t("harm.stall"), null, () => injectFault(name, "stall"), !on || isDown),
    menuItem("harm-mute", t("harm.mute"), null, () => injectFault(name, "mute"), !on || isMuted),
    ...(byRadio ? [menuItem("harm-apart", t("harm.apart"), null, () => injectFault(name, "apart"), !on)] : []),
    menuItem(
      "harm-revive",
      t("harm.revive"),
      null,
      () => injectFault(name, "revive"),
      !on || !(isDown || isMuted || byRadio),
    ),
    { kind: "line", id: "harm-1" },
    menuCheck("harm-follow", t("harm.follow"), followed === name, () => follow(name)),
  ];
}

function Open({ name, x, y, onClosed }: { name: string; x: number; y: number; onClosed: () => void }) {
  const on = useRun((state) => can("fail", state));
  // A run may begin or end while the menu is open; what is in it keeps its order meanwhile.
  const entries = useMemo(() => entriesOf(name, on), [name, on]);
  return (
    <FloatingMenu
      id="robot"
      label={t("harm.menu", { name })}
      at={{ x, y }}
      entries={entries}
      onLeave={closeRobotMenu}
      onClose={() => {
        closeRobotMenu();
        onClosed();
      }}
    />
  );
}
