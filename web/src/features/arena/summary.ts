/** A summary of the arena for screen readers. */
import { t } from "../../i18n/words";
import { lightsOf } from "../../components/scene/boards";
import { signAt } from "../../components/scene/geometry";
import type { Scene, Seen } from "../../components/scene/scene";

/** Up to so many robots are listed; more are counted, and only those with a fault are named. */
const MOST_TOLD = 20;

/** What befell a robot, in words. */
export function states({ failed, stalled, muted }: Pick<Seen, "failed" | "stalled" | "muted">): string[] {
  return [
    ...(failed ? [t("arena.failed")] : []),
    ...(stalled && !failed ? [t("arena.stalled")] : []),
    ...(muted ? [t("arena.muted")] : []),
  ];
}

export function summary(scene: Scene, seen: readonly Seen[]): string {
  const parts: string[] = [];
  if (scene.total > 0) parts.push(t("arena.delivered-of", { done: scene.delivered, total: scene.total }));
  const stock = Object.entries(scene.stock).map(([name, count]) => `${name} ${String(count)}`);
  if (stock.length > 0) parts.push(t("arena.stock", { stock: stock.join(", ") }));
  if (scene.collisions > 0) parts.push(t("arena.collisions", { count: scene.collisions }));
  const robots = seen.filter(({ actor, failed, stalled, muted }) => {
    return actor.role === "robot" || failed || stalled || muted;
  });
  const many = robots.length > MOST_TOLD;
  if (many) parts.push(`${t("arena.crowd", { count: robots.length })}.`);
  const told = many ? robots.filter((one) => states(one).length > 0).slice(0, MOST_TOLD) : robots;
  for (const one of told) {
    const { actor, pose } = one;
    const sign = actor.role === "robot" ? signAt(scene.world, pose.x_mm, pose.y_mm) : null;
    const where =
      sign === null
        ? t("arena.robot", { name: actor.name, x: Math.round(pose.x_mm), y: Math.round(pose.y_mm) })
        : t("arena.robot-section", { name: actor.name, sign });
    const lights = actor.face?.rows.flatMap(lightsOf).filter((light) => light > 0).length ?? 0;
    const lit = lights > 0 ? [t("arena.lights", { count: lights })] : [];
    const shown = actor.indicators
      .filter(({ value }) => value !== 0)
      .map(({ label, value }) => `${label} ${String(value)}`);
    parts.push(
      `${[where, ...lit, ...shown, ...(pose.load > 0 ? [t("arena.loaded")] : []), ...states(one)].join(", ")}.`,
    );
  }
  return parts.join(" ");
}
