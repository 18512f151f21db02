/** How many bodies a constructor with a repeated slot has. */
import { t } from "../../i18n/words";
import { addBranch, removeBranch } from "../../model/commands/changeBranches";
import type { Block } from "../../model/structure";
import { execute } from "../../model/studio";
import { useDrawing } from "../../session/drawing";
import { Icon } from "../../theme";

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
    <div className="inspector-row row" role="group" aria-label={t("inspector.branches")}>
      <span className="inspector-label rigid">{t("inspector.branches")}</span>
      <span className="inspector-space" />
      <span className="inspector-count row">
        <button
          type="button"
          aria-label={t("inspector.remove-branch")}
          title={t("inspector.remove-branch")}
          disabled={less === null}
          onClick={() => execute(less)}
        >
          <Icon name="minus" />
        </button>
        <output>{bodies.length}</output>
        <button
          type="button"
          data-testid="add-branch"
          aria-label={t("inspector.add-branch")}
          title={t("inspector.add-branch")}
          onClick={() => execute(addBranch(program, parts, id))}
        >
          <Icon name="plus" />
        </button>
      </span>
    </div>
  );
}
