/** The program in view as LLL that can be written: its text, what is marked in it, and the line about mistakes below. */
import { useCallback, useEffect, useMemo } from "react";
import { create } from "zustand";

import { api, problemsIn } from "../../api/client";
import { teamNames } from "../../components/text/team-names";
import { TextEditor } from "../../components/text/TextEditor";
import { Said } from "../../i18n/Said";
import { sentence, t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { Problem, SpanEntry } from "../../model/types";
import { spansInUnits } from "../../session/places";
import { useActiveVertices } from "../../session/run";
import { connectTyping, type Draft, setFocused, typeText, useTyping } from "../../session/typing";
import { Icon } from "../../theme";
import { endAll, listen } from "../../ui/effects";
import { showMistakes } from "./mistakes";
import { activeLines, vertexAt, vertexOfLine } from "./spans";

/** Why the graph does not show the text, for as long as it does not. */
function StateLine({ draft }: { draft: Draft | undefined }) {
  const wrong = draft !== undefined && !draft.right;
  const first = draft?.problems.find((problem) => problem.severity === "error");
  const why = draft?.failure !== "" ? draft?.failure : undefined;
  return (
    <div className="code-state" id="code-state" role="status" data-testid="code-state">
      {wrong ? (
        <>
          <Icon name="octagon-x" size={16} />
          <span>
            <span className="muted">{t("code.stale")}</span> <Said text={sentence(why ?? first?.message ?? "")} />
          </span>
        </>
      ) : null}
    </div>
  );
}

export function Lll({
  printed,
  spans: printedSpans,
  program,
}: {
  printed: string;
  spans: SpanEntry[];
  program: string;
}) {
  const draft = useTyping((typing) => typing.drafts[program]);
  const report = useStudio((studio) => studio.report);
  const selection = useStudio((studio) => studio.selection);
  const pointed = usePointed((pointing) => pointing.vertex);
  const active = useActiveVertices(program);
  const text = draft?.text ?? printed;
  const spans = useMemo(
    () => spansInUnits(draft === undefined ? printedSpans : draft.spans, text),
    [draft, printedSpans, text],
  );
  const problems = useMemo((): readonly Problem[] | null => {
    if (draft !== undefined) return draft.waiting ? null : draft.problems;
    return problemsIn(report, program);
  }, [draft, report, program]);
  const shown = useMemo(
    () => ({
      active: activeLines(spans, active),
      selected: spans.filter((span) => selection.includes(span.vertex)),
      pointed: spans.filter((span) => span.vertex === pointed),
    }),
    [spans, active, selection, pointed],
  );

  useEffect(() => {
    return endAll(connectTyping(api.follow), showMistakes(), watchGraph(), () => outlineVertex(null));
  }, []);

  const onPick = useCallback(
    (offset: number, byMouse: boolean) => {
      const line = text.slice(0, offset).split("\n").length;
      const start = text.lastIndexOf("\n", offset - 1) + 1;
      const indent = /^\s*/.exec(text.slice(start))?.[0].length ?? 0;
      const inText = offset >= start + indent;
      const found = byMouse || inText ? vertexAt(spans, offset) : vertexOfLine(spans, line, start + indent);
      if (found !== null) useStudio.getState().select([found]);
    },
    [text, spans],
  );
  const onType = useCallback(
    (now: string, before: string) => {
      typeText(program, now, { text: before, spans: printedSpans });
    },
    [program, printedSpans],
  );
  const onFocus = useCallback(
    (on: boolean) => {
      setFocused(program, on);
    },
    [program],
  );
  const onPoint = useCallback(
    (offset: number | null) => {
      outlineVertex(offset === null ? null : vertexAt(spans, offset));
    },
    [spans],
  );
  const around = useMemo(
    () => ({
      program,
      parts: () => {
        const { mission, catalogue } = useStudio.getState();
        const robot = mission.programs.find((one) => one.name === program)?.robot;
        const names = teamNames(mission, catalogue.robots, program);
        return { catalogue, robot: catalogue.robots.find((one) => one.name === robot), names };
      },
      elementAt: (offset: number) => {
        const vertex = vertexAt(spans, offset);
        const { mission } = useStudio.getState();
        const found = mission.programs.find((one) => one.name === program)?.vertices.find((one) => one.id === vertex);
        return found?.element ?? null;
      },
    }),
    [program, spans],
  );
  return (
    <div className="code-lll column">
      <TextEditor
        text={text}
        label={t("code.label", { name: program })}
        empty={t("code.empty")}
        shown={shown}
        problems={problems}
        settled={draft === undefined || (draft.right && !draft.waiting)}
        around={around}
        onType={onType}
        onFocus={onFocus}
        onPick={onPick}
        onPoint={onPoint}
      />
      <StateLine draft={draft} />
    </div>
  );
}

/** The vertex under the pointer in the graph; the text shows its lines. */
const usePointed = create<{ vertex: string | null }>(() => ({ vertex: null }));

function ownSheet(): () => CSSStyleSheet {
  let sheet: CSSStyleSheet | null = null;
  return () => {
    if (sheet === null) {
      sheet = new CSSStyleSheet();
      document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
    }
    return sheet;
  };
}

const outlineSheet = ownSheet();

/** Outlines a vertex of the graph, or none. */
function outlineVertex(vertex: string | null): void {
  if (typeof CSSStyleSheet.prototype.replaceSync !== "function") return;
  const sheet = outlineSheet();
  const rule = "{ filter: drop-shadow(0 0 0 var(--ink)) drop-shadow(0 0 1.5px var(--ink)); }";
  sheet.replaceSync(vertex === null ? "" : `.canvas-node[data-id="${CSS.escape(vertex)}"] ${rule}`);
}

/** Watches the pointer over the graph; the returned function ends that. */
function watchGraph(): () => void {
  const onOver = (event: PointerEvent) => {
    const target = event.target instanceof Element ? event.target : null;
    const part = target?.closest<HTMLElement>(".canvas-node[data-id]");
    const vertex = part?.dataset["id"] ?? null;
    if (vertex !== usePointed.getState().vertex) usePointed.setState({ vertex });
  };
  return endAll(listen(document, { pointerover: onOver }, { passive: true }), () =>
    usePointed.setState({ vertex: null }),
  );
}
