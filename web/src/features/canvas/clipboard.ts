/**
 * Cut, copy and paste of the selection.
 *
 * The clipboard holds LLL text, so it goes to any window and any editor; beside it, for our own pages, the piece as it is,
 * which keeps vertices that LLL cannot say yet (an open condition). A text that was typed elsewhere is read by the
 * server. What cannot be pasted is said in a sentence and changes nothing.
 */
import { useEffect } from "react";
import { create } from "zustand";

import { api } from "../../api/client";
import { sentence, t } from "../../i18n/words";
import { pasteParts } from "../../model/commands/pasteParts";
import { blocksOf, type Copied, copyOf, readPiece } from "../../model/fragment";
import { placeFor } from "../../model/placeFor";
import { useStudio } from "../../model/studio";
import type { Program } from "../../model/types";
import { currentDrawing } from "../../session/drawing";
import { deleteSelection, edit } from "../../session/edits";
import { sayOnCanvas, useView } from "../../session/view";
import { listen } from "../../ui/effects";

const PIECE = "application/x-kitrobot-piece";

/** What was copied here last: a menu can read the text only. */
const useCopied = create<{ lll: string; piece: Program | null }>(() => ({ lll: "", piece: null }));

function say(words: string): void {
  sayOnCanvas(words);
}

function copiedNow(): Copied | null {
  const drawing = currentDrawing();
  return drawing === null ? null : copyOf(drawing.structure, useStudio.getState().selection);
}

/** Copies the selection into a clipboard; says whether there was something. */
function fill(clipboard: DataTransfer): boolean {
  const copied = copiedNow();
  if (copied === null) return false;
  useCopied.setState({ lll: copied.lll, piece: copied.program });
  clipboard.setData("text/plain", copied.lll);
  clipboard.setData(PIECE, JSON.stringify(copied.program));
  return true;
}

/** Puts a piece where the selection says; says whether it could. */
export function pastePiece(piece: Program): boolean {
  return edit(({ program, parts, structure, layout }) => {
    const blocks = blocksOf(piece, parts);
    const [first] = blocks;
    if (first === undefined) return null;
    const arc = layout.arcs.find((one) => one.id === useView.getState().arc) ?? null;
    const around = { vertex: useStudio.getState().selection.at(-1) ?? null, arc };
    // Several blocks go on an arc, never into a slot.
    const shape = blocks.find((block) => block.bodies.length > 0)?.shape ?? first.shape;
    const place = placeFor(structure, around, shape);
    if (place === null) return null;
    const onArc = place.kind === "slot" && blocks.length > 1;
    return (
      pasteParts(program, parts, onArc ? { kind: "arc", source: place.vertex, out: "next" } : place, piece) ??
      pasteParts(program, parts, { kind: "void" }, piece)
    );
  });
}

/** Pastes a text: our own piece as it was copied, any other as the server reads it. */
export async function pasteText(text: string): Promise<void> {
  const last = useCopied.getState();
  if (last.piece !== null && text.trim() === last.lll.trim()) {
    pastePiece(last.piece);
    return;
  }
  const drawing = currentDrawing();
  if (drawing === null) return;
  if (text.trim() === "") {
    say(t("paste.empty"));
    return;
  }
  try {
    const { file, mission } = useStudio.getState();
    const { program, problems } = await api.fragment(text, drawing.program.robot, file.path, mission);
    const [problem] = problems;
    if (program === null) {
      say(t("paste.rubbish", { why: problem === undefined ? "" : sentence(problem.message) }).trim());
    } else if (currentDrawing()?.program !== drawing.program || !pastePiece(program)) {
      say(t("paste.nothing"));
    }
  } catch (cause) {
    say(cause instanceof Error ? cause.message : t("paste.nothing"));
  }
}

/** From a menu: only the text can be written; this page remembers the piece beside it. */
export async function copySelection(): Promise<boolean> {
  const copied = copiedNow();
  if (copied === null) return false;
  try {
    await navigator.clipboard.writeText(copied.lll);
  } catch {
    say(t("copy.by-key"));
    return false;
  }
  useCopied.setState({ lll: copied.lll, piece: copied.program });
  return true;
}

export async function cutSelection(): Promise<void> {
  if (await copySelection()) deleteSelection();
}

export async function pasteFromMenu(): Promise<void> {
  let text: string;
  try {
    text = await navigator.clipboard.readText();
  } catch {
    say(t("paste.by-key"));
    return;
  }
  await pasteText(text);
}

/** Whether the event belongs to a field, the code or a selected text. */
function isText(event: Event): boolean {
  const target = event.target instanceof Element ? event.target : document.body;
  if (target.closest("input, textarea, select, [contenteditable=true], [role=dialog]") !== null) return true;
  return event.type !== "paste" && document.getSelection()?.isCollapsed === false;
}

/** Listens to the browser's clipboard events; stands once in the canvas. */
export function useClipboard(): void {
  useEffect(() => {
    const onCopy = (event: ClipboardEvent) => {
      if (isText(event) || event.clipboardData === null || !fill(event.clipboardData)) return;
      event.preventDefault();
      if (event.type === "cut") deleteSelection();
    };
    const onPaste = (event: ClipboardEvent) => {
      const { clipboardData } = event;
      if (isText(event) || clipboardData === null || clipboardData.files.length > 0) return;
      event.preventDefault();
      const piece = readPiece(clipboardData.getData(PIECE));
      if (piece !== null) {
        if (!pastePiece(piece)) say(t("paste.nothing"));
      } else void pasteText(clipboardData.getData("text/plain"));
    };
    return listen(document, { copy: onCopy, cut: onCopy, paste: onPaste });
  }, []);
}
