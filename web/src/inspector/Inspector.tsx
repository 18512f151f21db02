/** What can be set on the selected part. */
import "./inspector.css";

import type { ReactNode } from "react";

import { deleteSelection, duplicateSelection } from "../editor/edits";
import { type Drawing, useDrawing } from "../editor/drawing";
import { setNote } from "../model/commands/setNote";
import { noteText } from "../model/notes";
import { title } from "../model/parts";
import { useStudio } from "../model/studio";
import { text } from "../model/texts";
import { findSpot, type Spot, withMark } from "../model/tree";
import type { Vertex } from "../model/types";
import { Icon, Tile } from "../theme";
import { complain } from "../shell/document";
import { later } from "../shell/later";
import { t } from "../words/words";
import { BlockEditor } from "./BlockEditor";
import { Branches } from "./Branches";
import { Marks } from "./Marks";

const BreakpointEditor = later(
  () => import("../debug/BreakpointEditor").then((chunk) => chunk.BreakpointEditor),
  complain,
);

export function Inspector() {
  const drawing = useDrawing();
  const selection = useStudio((state) => state.selection);
  const [id] = selection;
  if (drawing === null || id === undefined) return <Nothing />;
  if (selection.length > 1) return <Many count={selection.length} />;
  const { start, stop } = drawing.structure;
  if (id === start?.id) return <Terminal name={t("graph.start")} help={t("inspector.start")} />;
  if (id === stop?.id) return <Terminal name={t("graph.stop")} help={t("inspector.stop")} />;
  const spot = findSpot(drawing.structure, id);
  return spot === undefined ? <Nothing /> : <One key={`${drawing.program.name} ${id}`} drawing={drawing} spot={spot} />;
}

function Nothing() {
  return (
    <div className="inspector">
      <header className="inspector-head">
        <h2>{t("inspector.title")}</h2>
      </header>
      <div className="inspector-nothing">
        <Icon name="mouse-pointer-2" size={18} />
        <p>
          <strong>{t("inspector.nothing")}</strong>
          {t("inspector.nothing-help")}
        </p>
      </div>
    </div>
  );
}

function Terminal({ name, help }: { name: string; help: string }) {
  return (
    <div className="inspector">
      <header className="inspector-head">
        <h2>{name}</h2>
      </header>
      <p className="inspector-help">{help}</p>
    </div>
  );
}

function Many({ count }: { count: number }) {
  return (
    <div className="inspector">
      <header className="inspector-head">
        <h2>{t("inspector.many", { count })}</h2>
        <Tools />
      </header>
    </div>
  );
}

function Tools() {
  return (
    <span className="inspector-tools">
      <Tool icon="copy" label={t("inspector.duplicate")} run={duplicateSelection} />
      <Tool icon="trash-2" label={t("inspector.delete")} run={deleteSelection} />
    </span>
  );
}

function Tool({ icon, label, run }: { icon: string; label: string; run: () => void }) {
  return (
    <button type="button" aria-label={label} title={label} onClick={run}>
      <Icon name={icon} size={18} />
    </button>
  );
}

function One({ drawing, spot }: { drawing: Drawing; spot: Spot }) {
  const { shape, vertex } = spot.block;
  const line = useLine(vertex.id, withMark(spot).block.vertex.id);
  const icon = shape.method?.icon || shape.icon;
  const help = text(shape.help);
  return (
    <div className="inspector" data-testid="inspector">
      <header className="inspector-head">
        <Tile icon={icon} colour={shape.colour} size={22} />
        <h2>{title(shape)}</h2>
        {line === null ? null : <span className="inspector-line">{t("inspector.line", { line })}</span>}
        <Tools />
      </header>
      <BlockEditor drawing={drawing} spot={spot} />
      {shape.kind === "unknown" ? (
        <p className="inspector-help">{t("inspector.unknown", { element: shape.element })}</p>
      ) : null}
      {help === "" ? null : <p className="inspector-help">{help}</p>}
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
  const execute = useStudio((state) => state.execute);
  if (drawing === null) return null;
  return (
    <label className="inspector-note">
      <span>{t("inspector.note")}</span>
      <textarea
        rows={1}
        dir="auto"
        placeholder={t("inspector.note-hint")}
        value={noteText(vertex.notes)}
        onChange={(event) => {
          const command = setNote(drawing.program, vertex.id, event.target.value);
          if (command !== null) execute(command);
        }}
      />
    </label>
  );
}
