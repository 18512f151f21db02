/** The arena in words, for those who cannot see it. */
import { t } from "../words/words";
import type { Scene, Seen } from "./scene";

export function summary(scene: Scene, seen: readonly Seen[]): string {
  const parts: string[] = [];
  if (scene.total > 0) parts.push(t("arena.delivered-of", { done: scene.delivered, total: scene.total }));
  const stock = Object.entries(scene.stock).map(([name, count]) => `${name} ${String(count)}`);
  if (stock.length > 0) parts.push(t("arena.stock", { stock: stock.join(", ") }));
  if (scene.collisions > 0) parts.push(t("arena.collisions", { count: scene.collisions }));
  for (const { actor, pose, sign, failed } of seen) {
    if (actor.role !== "robot") continue;
    const where =
      sign === null
        ? t("arena.robot", { name: actor.name, x: Math.round(pose.x_mm), y: Math.round(pose.y_mm) })
        : t("arena.robot-section", { name: actor.name, sign });
    const extras = [...(pose.load > 0 ? [t("arena.loaded")] : []), ...(failed ? [t("arena.failed")] : [])];
    parts.push(`${[where, ...extras].join(", ")}.`);
  }
  return parts.join(" ");
}
