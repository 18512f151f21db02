/** How many bodies a constructor with a repeated slot has. */
import { t } from "../../i18n/words";
import { addBranch, removeBranch } from "../../model/commands/changeBranches";
import type { Block } from "../../model/structure";
import { execute } from "../../model/studio";
import { useDrawing } from "../../session/drawing";
import { Tool } from "../../ui/Tool";

export function Branches({ block }: { block: Block }) {
  const drawing = useDrawing();
  const flow = block.shape.flows.find((one) => one.repeat);
  if (flow === undefined || drawing === null) return null;
  const { program, parts } = drawing;
  const { id } = block.vertex;
  const bodies = block.bodies.filter((body) => body.out.startsWith(`${flow.name}.`));
  // An empty branch goes before one that holds something.
  const last = bodies.findLast((body) => body.chain.length === 0) ?? bodies.at(-1);
  const less = last === undefined ? null : removeBranch(program, parts, id, last.out);
  return (
    <div className="field-row row" role="group" aria-label={t("inspector.branches")}>
      <span className="field-label rigid">{t("inspector.branches")}</span>
      <span className="grow" />
      <span className="inspector-count aligned">
        <Tool
          icon="minus"
          label={t("inspector.remove-branch")}
          disabled={less === null}
          onClick={() => execute(less)}
        />
        <output>{bodies.length}</output>
        <Tool
          icon="plus"
          testId="add-branch"
          label={t("inspector.add-branch")}
          onClick={() => execute(addBranch(program, parts, id))}
        />
      </span>
    </div>
  );
}
