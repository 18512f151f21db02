/** Over an arena with very many robots: how many run which program, which of them stand out, and how many failed. */
import "./crowd.css";

import { useMemo } from "react";

import { FAILED } from "../../api/wire";
import { CROWD } from "../../components/scene/crowd-size";
import type { Scene } from "../../components/scene/scene";
import { grouped } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { posesAt } from "../../session/poses";
import { Select } from "../../ui/Select";
import { highlightProgram, useRobots } from "./robots";

export function Crowd({ scene }: { scene: Scene | null }) {
  const program = useRobots((state) => state.program);
  const count = scene?.actors.length ?? 0;
  const programs = useMemo(() => {
    const counts = new Map<string, number>();
    for (const actor of scene?.actors ?? []) counts.set(actor.program, (counts.get(actor.program) ?? 0) + 1);
    return [...counts].sort((a, b) => b[1] - a[1]);
  }, [scene?.actors]);
  if (scene === null || count < CROWD) return null;
  const poses = scene.running ? (posesAt(0, false)?.poses ?? []) : [];
  const failed = poses.reduce((sum, pose) => sum + ((pose.flags & FAILED) !== 0 ? 1 : 0), 0);
  return (
    <div className="arena-crowd row rigid" data-testid="crowd">
      <Select
        label={t("arena.crowd-filter")}
        testId="crowd-program"
        value={program}
        options={[
          ["", t("arena.crowd-all", { count: grouped(count) })],
          ...programs.map(([name, of]) => [name, t("arena.crowd-of", { count: grouped(of), program: name })] as const),
        ]}
        wrong={false}
        keep={highlightProgram}
      />
      {failed === 0 ? null : (
        <span className="side-note ellipsis muted small-text">
          {t("arena.crowd-failed", { count: grouped(failed) })}
        </span>
      )}
    </div>
  );
}
