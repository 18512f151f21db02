/** What an arena without a world or without robots says: why it is empty, and what to do about it. */
import type { Scene } from "../../components/scene/scene";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";

export function EmptyArena({ scene }: { scene: Scene | null }) {
  const opened = useStudio((studio) => studio.mission.programs.length > 0);
  if (scene?.real === true) {
    return (
      <p className="arena-empty boxed" data-testid="arena-real">
        {t("arena.real")}
      </p>
    );
  }
  if (!opened || (scene !== null && scene.actors.length > 0)) return null;
  return (
    <p className="arena-empty boxed" data-testid="arena-empty">
      {t(scene === null ? "arena.no-world" : "arena.no-robot")}
    </p>
  );
}
