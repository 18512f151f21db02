/** Under a new program: what to do first, four parts to begin with, and what other features add (tutorials, examples). */
import { PanelSlot } from "../../components/Slot";
import { handKey } from "../../i18n/touch";
import { t } from "../../i18n/words";
import { firstParts } from "../../model/part-groups";
import { shortTitle } from "../../model/parts";
import { firstSentence, text } from "../../model/texts";
import { useDocument } from "../../session/document";
import { beginDrag, justDragged } from "../../session/drag";
import type { Drawing } from "../../session/drawing";
import { addPartAt } from "../../session/edits";
import { openRoom } from "../../session/narrow";
import { Tile } from "../../theme";

const MOST_LETTERS = 44;

/** The first sentence of a help text without its stop, or the beginning of it when it is long. */
function inShort(help: string): string {
  const sentence = firstSentence(help).replace(/[.۔]$/u, "");
  return sentence.length <= MOST_LETTERS ? sentence : (/^[^,;:،؛]*/u.exec(sentence)?.[0] ?? sentence);
}

export function FirstSteps({ drawing }: { drawing: Drawing }) {
  // The sheet for opening has the same.
  const choosing = useDocument((document) => document.overlay === "open");
  const start = drawing.structure.start?.id ?? "start";
  return (
    <section className="teaching text-centre">
      <h2>{t("graph.first-step")}</h2>
      <p>{t(handKey("graph.first-help"))}</p>
      <ul className="teaching-parts gap-2xl">
        {firstParts(drawing.parts).map((shape) => (
          <li key={shape.element}>
            <button
              type="button"
              className="card surface row"
              data-testid={`first-${shape.element}`}
              onPointerDown={(event) => beginDrag(event, { kind: "part", element: shape.element })}
              onClick={() => {
                if (justDragged()) return;
                addPartAt({ kind: "arc", source: start, out: "next" }, shape.element);
                // What comes next is among the parts.
                openRoom("palette");
              }}
            >
              <Tile icon={shape.icon} colour={shape.colour} size={36} />
              <span className="slim">
                <strong>{shortTitle(shape)}</strong>
                <small>{inShort(text(shape.help))}</small>
              </span>
            </button>
          </li>
        ))}
      </ul>
      {choosing ? null : <PanelSlot place="empty-program" />}
    </section>
  );
}
