/** The small controls that fold a constructor: in the corner of its frame, and on it once it is folded. */
import { t } from "../../i18n/words";
import type { LayoutFrame, LayoutNode } from "../../model/layout";
import { title } from "../../model/parts";
import { currentDrawing } from "../../session/drawing";
import { holdingStill } from "../../session/view";
import { Icon } from "../../theme";
import { toggleFold } from "./fold-state";

function named(id: string): string {
  const block = currentDrawing()?.nodes.get(id)?.block;
  return block == null ? id : title(block.shape);
}

export function FoldControls({ frames }: { frames: LayoutFrame[] }) {
  return (
    <>
      {frames.map(({ id, kind, x, y, w }) => {
        if (kind === "parked") return null;
        // Below the half of the vertex that stands in the frame; a bar has its name tag on the left.
        const [right, down] = kind === "parallel" ? [w - 23, 7] : [5, 23];
        const words = t("graph.fold", { name: named(id) });
        return (
          <button
            key={id}
            type="button"
            className="fold centred muted"
            data-testid={`collapse-${id}`}
            aria-label={words}
            aria-expanded="true"
            title={words}
            tabIndex={-1}
            style={{ transform: `translate(${String(x + right)}px, ${String(y + down)}px)` }}
            onClick={(event) => {
              event.stopPropagation();
              holdingStill(() => {
                toggleFold(id);
              });
            }}
          >
            <Icon name="chevron-down" size={14} />
          </button>
        );
      })}
    </>
  );
}

/** On a folded vertex: how much is inside; a click unfolds it. */
export function FoldedWords({ node }: { node: LayoutNode }) {
  if (node.inside === null) return null;
  return (
    <button
      type="button"
      className="folded inline-row bold nowrap gap-2xs"
      data-testid={`expand-${node.vertex}`}
      aria-expanded="false"
      title={t("graph.unfold", { name: named(node.vertex) })}
      tabIndex={-1}
      onPointerDown={(event) => event.stopPropagation()}
      onClick={(event) => {
        event.stopPropagation();
        holdingStill(() => {
          toggleFold(node.vertex);
        });
      }}
    >
      <Icon name="chevron-right" size={14} />
      {t("graph.folded", { count: node.inside.count })}
    </button>
  );
}
