/** What can be set on the one part that is selected; fetched when a part is selected first. */
import type { ReactNode } from "react";

import { t } from "../../i18n/words";
import { setNote } from "../../model/commands/setNote";
import { noteText } from "../../model/notes";
import { title } from "../../model/parts";
import { execute, useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { type Spot, withMark } from "../../model/tree";
import type { Vertex } from "../../model/types";
import { type Drawing, useDrawing } from "../../session/drawing";
import { useShown } from "../../session/simple-view";
import { Tile } from "../../theme";
import { BlockEditor } from "./BlockEditor";
import { Branches } from "./Branches";
import { BreakpointEditor } from "./BreakpointEditor";
import { Marks } from "./Marks";
import { Tools } from "./Tools";

export function Part({ drawing, spot }: { drawing: Drawing; spot: Spot }) {
  const { shape, vertex } = spot.block;
  const places = useShown("places");
  const line = useLine(vertex.id, withMark(spot).block.vertex.id);
  const icon = shape.method?.icon || shape.icon;
  const help = text(shape.help);
  return (
    <div className="inspector column" data-testid="inspector">
      <header className="inspector-head row">
        <Tile icon={icon} colour={shape.colour} size={22} />
        <h2>{title(shape)}</h2>
        {!places || shape.kind === "unknown" || shape.element === title(shape) ? null : (
          <code
            className="inspector-element ellipsis muted slim code-text"
            title={t("fields.in-lll", { name: shape.element })}
          >
            {shape.element}
          </code>
        )}
        {!places || line === null ? null : <span className="muted rigid">{t("inspector.line", { line })}</span>}
        <Tools />
      </header>
      <BlockEditor drawing={drawing} spot={spot} />
      {shape.kind === "unknown" ? (
        <p className="inspector-help muted small-text below prose">
          {t("inspector.unknown", { element: shape.element })}
        </p>
      ) : null}
      {help === "" ? null : <p className="inspector-help muted small-text below prose">{help}</p>}
      <Branches block={spot.block} />
      <Marks drawing={drawing} spot={spot} />
      <NoteField vertex={vertex} />
      <BreakpointEditor id={vertex.id} />
    </div>
  );
}

/** The line of LLL in which the vertex stands, as the last check said. */
function useLine(id: string, mark: string): number | null {
  return useStudio(({ report, activeProgram }) => {
    const spans = report?.programs.find((one) => one.name === activeProgram)?.spans ?? [];
    return (spans.find((span) => span.vertex === id) ?? spans.find((span) => span.vertex === mark))?.line ?? null;
  });
}

function NoteField({ vertex }: { vertex: Vertex }): ReactNode {
  const drawing = useDrawing();
  if (drawing === null) return null;
  return (
    <label className="inspector-note flex gap-xl inspector-part items-start">
      <span>{t("inspector.note")}</span>
      <textarea
        className="field"
        rows={1}
        dir="auto"
        placeholder={t("inspector.note-hint")}
        value={noteText(vertex.notes)}
        onChange={(event) => execute(setNote(drawing.program, vertex.id, event.target.value))}
      />
    </label>
  );
}
