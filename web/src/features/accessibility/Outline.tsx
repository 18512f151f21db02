/**
 * The outline: the program in view as a tree of text beside the graph, for screen readers and for reading.
 *
 * Its rows are made only while it is open. A row that has the focus is selected in the graph; Delete and the keys with
 * Ctrl do there what they do on the graph, since that listens to every tree of the page (editor/keys.ts).
 */
import { type KeyboardEvent, useEffect, useMemo, useRef, useState } from "react";
import { createPortal } from "react-dom";

import { mirrored } from "../../i18n/language";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { type Drawing, useDrawing } from "../../session/drawing";
import { editSelected, openAdding, useView } from "../../session/view";
import { Tool } from "../../ui/Tool";
import { outlineOf, rowAbove } from "./outline";
import { closeOutline, useAccessibility } from "./state";

export function Outline() {
  const open = useAccessibility((state) => state.outline);
  const drawing = useDrawing();
  const panel = document.getElementById("canvas-panel");
  return open && drawing !== null && panel !== null ? createPortal(<Open drawing={drawing} />, panel) : null;
}

function Open({ drawing }: { drawing: Drawing }) {
  const rows = useMemo(() => outlineOf(drawing.structure), [drawing]);
  const selected = useStudio((state) => state.selection.at(-1) ?? null);
  const [body, setBody] = useState<string | null>(null);
  const tree = useRef<HTMLDivElement>(null);
  const inside = useRef(true);
  const bodyAt = rows.findIndex((row) => row.key === body && row.vertex === null);
  const selectedAt = rows.findIndex((row) => row.vertex !== null && row.vertex === selected);
  const at = Math.max(bodyAt >= 0 ? bodyAt : selectedAt, 0);
  const key = rows[at]?.key;

  // The focus stays in the tree when the row that had it is gone.
  useEffect(() => {
    if (inside.current) tree.current?.querySelector<HTMLElement>('[tabindex="0"]')?.focus();
  }, [key, rows]);

  const go = (to: number) => {
    const row = rows[to];
    if (row === undefined) return;
    inside.current = true;
    setBody(row.vertex === null ? row.key : null);
    if (row.vertex !== null) useStudio.getState().select([row.vertex]);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const [inwards, outwards] = mirrored() ? ["ArrowLeft", "ArrowRight"] : ["ArrowRight", "ArrowLeft"];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "ArrowDown") go(at + 1);
    else if (event.key === "ArrowUp") go(at - 1);
    else if (event.key === "Home") go(0);
    else if (event.key === "End") go(rows.length - 1);
    else if (event.key === inwards) {
      if ((rows[at + 1]?.level ?? 0) > (rows[at]?.level ?? 0)) go(at + 1);
    } else if (event.key === outwards) go(rowAbove(rows, at));
    else if (event.key === "Enter") editSelected();
    else if (event.key === "/") openAdding();
    else if (event.key === "Escape") {
      closeOutline();
      useView.getState().viewport?.focus();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <section className="outline-panel column" aria-label={t("outline.title")} data-testid="outline">
      <header className="panel-head row between rigid">
        <h2 className="panel-title">{t("outline.title")}</h2>
        <Tool small icon="x" label={t("outline.close")} titled={false} onClick={closeOutline} />
      </header>
      <div
        role="tree"
        aria-label={t("outline.of", { name: drawing.program.name })}
        ref={tree}
        onKeyDown={onKeyDown}
        onFocus={() => {
          inside.current = true;
        }}
        onBlur={(event) => {
          // A row that is taken away blurs to nothing; then the focus comes back.
          if (event.relatedTarget !== null) inside.current = false;
        }}
      >
        {rows.map((row, index) => (
          <div
            key={row.key}
            className="focus-inside"
            role="treeitem"
            aria-level={row.level}
            aria-selected={row.vertex !== null && row.vertex === selected}
            tabIndex={index === at ? 0 : -1}
            style={{ paddingInlineStart: 12 * row.level }}
            onFocus={() => {
              if (row.vertex !== null && row.vertex !== selected) go(index);
            }}
            onClick={() => go(index)}
          >
            <bdi>{row.words}</bdi>
          </div>
        ))}
      </div>
    </section>
  );
}
