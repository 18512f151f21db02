/**
 * What can be put into the world. A press on a tool takes it in hand for the next drag; from the keyboard, where nobody
 * drags, it puts the thing into the middle at once.
 */
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { KIND_ICONS, kindName } from "../../model/world/names";
import { type Kind, KINDS } from "../../model/world/part-reference";
import { put } from "../../session/world-edits";
import { ownWorld, takeTool, useWorld } from "../../session/world-view";
import { Icon } from "../../theme";
import { Tool } from "../../ui/Tool";

function middle(): { x: number; y: number } {
  const world = useStudio.getState().mission.own_world;
  const half = (mm: number) => Math.round(mm / 20) * 10;
  return { x: half(world?.width_mm ?? 0), y: half(world?.height_mm ?? 0) };
}

export function Tools() {
  const tool = useWorld((state) => state.tool);
  const take = (wanted: Kind | null) => takeTool(wanted);
  return (
    <div className="world-tools row wrap rigid gap-xs" role="toolbar" aria-label={t("world.tools")}>
      <Tool
        icon="mouse-pointer-2"
        label={t("world.choose")}
        testId="world-tool-choose"
        aria-pressed={tool === null}
        onClick={() => take(null)}
      />
      {KINDS.map((kind) => {
        // Where a start is put, a robot joins the team.
        const name = kind === "start" ? t("parts.robot") : kindName(kind);
        const label = t("world.add", { kind: name });
        return (
          <button
            key={kind}
            type="button"
            className="tool world-tool rigid"
            data-testid={`world-tool-${kind}`}
            aria-pressed={tool === kind}
            aria-label={label}
            title={label}
            onClick={(event) => {
              if (event.detail === 0 && ownWorld() !== null) put(kind, middle(), null);
              else take(tool === kind ? null : kind);
            }}
          >
            <Icon name={KIND_ICONS[kind]} size={18} />
            <span>{name}</span>
          </button>
        );
      })}
    </div>
  );
}
