/** What the sensor or variable of a chip says now: on the vertex, filled while the test is true. Comes with the first run. */
import "./live-value.css";

import { t } from "../../i18n/words";
import type { LayoutNode } from "../../model/layout";
import { storedNumber } from "../../model/meaning";
import { textWidth } from "../../model/measure";
import type { Block } from "../../model/structure";
import { useStudio } from "../../model/studio";
import { valueWords } from "../../model/words";
import { useRun, watchedAgent } from "../../session/run";
import { Icon } from "../../theme";

/** What is beside the words: padding, and the tick. */
const EDGE = 36;
/** Where it hangs: so far from the end of the vertex; of a loop further out, behind the label of the arc in the middle. */
const INSET = 24;
const LABEL = 30;

/** Whether the test is true for a value; null where that is not known here. */
export function isTrue({ shape, vertex, plugs }: Block, value: number): boolean | null {
  const { test, to } = shape.method ?? {};
  const [field] = shape.fields;
  const filled = plugs.some((plug) => plug.block !== null);
  const limit = to ?? (field === undefined || filled ? null : storedNumber(vertex.settings[field.name] ?? ""));
  if (limit === null || test === undefined || test === "") return null;
  return test === "equal" ? value === limit : test === "less" ? value < limit : value > limit;
}

export function LiveValue({ node, spare }: { node: LayoutNode; spare: number }) {
  const test = node.block?.plugs.find(({ slot }) => slot === node.face.chips[0]?.slot)?.block ?? null;
  const object = test?.shape.object ?? null;
  const program = useStudio((state) => state.activeProgram);
  const value = useRun((run) => {
    if (object === null || test?.shape.role !== "condition") return undefined;
    const agent = watchedAgent(run, program);
    return object.category === "sensor" ? agent?.inputs[object.name] : agent?.values[object.name];
  });
  if (value === undefined || object === null || test === null) return null;
  const words = t("graph.now", { value: valueWords(object, value) });
  const on = isTrue(test, value) === true;
  const width = textWidth(words, 13, true) + EDGE;
  const fits = node.inside === null && spare >= width;
  const inset = node.kind === "hexagon" ? INSET : Math.min(INSET, node.w / 2 - LABEL - width);
  return (
    <span
      className={
        fits
          ? "live-value inline-row rigid bold small-text nowrap gap-xs passive"
          : "live-value is-hung inline-row rigid bold small-text nowrap gap-xs passive"
      }
      style={fits ? undefined : { insetInlineEnd: inset }}
      data-on={on}
      data-testid={`live-${node.vertex}`}
    >
      {on ? <Icon name="check" size={12} /> : null}
      {words}
    </span>
  );
}
