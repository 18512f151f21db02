/** Switches for the marks that an action in a parallel can have: constructors whose only slot is an action. */
import { Switch } from "../../components/fields/FieldRow";
import { toggleMark } from "../../model/commands/toggleMark";
import { shortTitle } from "../../model/parts";
import { execute } from "../../model/studio";
import { text } from "../../model/texts";
import { canMark, markAround, type Spot } from "../../model/tree";
import type { Drawing } from "../../session/drawing";

/** Whether the spot is in a branch: in a body of a repeated slot. */
function inBranch(spot: Spot): boolean {
  for (let at: Spot | null = spot; at !== null; at = at.owner) {
    if (at.block !== spot.block && at.block.shape.flows.some((flow) => flow.repeat)) return true;
  }
  return false;
}

export function Marks({ drawing, spot }: { drawing: Drawing; spot: Spot }) {
  const { program, parts } = drawing;
  const around = markAround(spot);
  if (around === undefined && !(canMark(spot) && inBranch(spot))) return null;
  const offered = around === undefined ? parts.marks : parts.marks.filter((mark) => mark === around.block.shape);
  return offered.map((mark) => (
    <div key={mark.element} className="inspector-mark row gap-xl inspector-part">
      <span
        className="inspector-disc rigid centred"
        style={{ background: `var(--${mark.colour}-tile)`, color: `var(--${mark.colour}-on-tile)` }}
      >
        <svg width="20" height="20" viewBox="0 0 24 24" aria-hidden="true">
          <circle cx="12" cy="12" r="4.5" fill="none" stroke="currentColor" strokeWidth="2.75" />
        </svg>
      </span>
      <span className="grow">
        <strong>{shortTitle(mark)}</strong> <span className="muted small-text">{text(mark.help)}</span>
      </span>
      <Switch
        on={around !== undefined}
        label={shortTitle(mark)}
        testid={`mark-${mark.element}`}
        toggle={() => execute(toggleMark(program, parts, spot.block.vertex.id, mark.element))}
      />
    </div>
  ));
}
