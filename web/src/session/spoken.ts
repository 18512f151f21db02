/** What a screen reader says of a vertex and of an arc. */
import { t } from "../i18n/words";
import type { LayoutArc, LayoutNode } from "../model/layout";
import { title } from "../model/parts";
import { wordsOf } from "../model/words";
import { currentDrawing } from "./drawing";

/** Name, values and conditions in words. */
export function spoken({ block, face, mark, inside }: LayoutNode): string {
  if (block === null) return face.name;
  const values = face.boxes.map(({ label, value }) => `${label} ${value}`.trim());
  const conditions = block.plugs.flatMap((plug) =>
    plug.block === null || face.boxes.some((box) => box.slot === plug.slot) ? [] : [wordsOf(plug.block)],
  );
  const marked = mark === null ? [] : [title(mark.shape)];
  const hidden = inside === null ? [] : [t("graph.folded", { count: inside.count })];
  return [title(block.shape), ...conditions, ...values, ...marked, ...hidden].join(", ");
}

export function spokenArc({ source, out }: LayoutArc): string {
  const drawing = currentDrawing();
  const shape = drawing?.parts.shape(drawing.program.vertices.find((one) => one.id === source)?.element ?? "");
  const name = shape === undefined ? source : title(shape);
  return out === "next" ? t("graph.arc", { name }) : t("graph.arc-body", { name, slot: out });
}
