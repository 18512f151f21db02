/** Under a new program: what to do first, four parts to begin with, and what other features add (tutorials, examples). */
import { PanelSlot } from "../../components/Slot";
import { type Parts, type Shape, shortTitle } from "../../model/parts";
import { firstSentence, text } from "../../model/texts";
import { Tile } from "../../theme";
import { t } from "../../i18n/words";
import { useDocument } from "../../session/document";
import { beginDrag, justDragged } from "../../session/drag";
import type { Drawing } from "../../session/drawing";
import { addPartAt } from "../../session/edits";
import { hasCoarsePointer } from "../../ui/coarse-pointer";

/** An action that shows at once, then one constructor of each colour that holds a body. */
export function firstParts({ all }: Parts): Shape[] {
  const actions = all.filter((shape) => shape.object?.category === "actuator" && shape.role === "instruction");
  const lasting = actions.filter((shape) => shape.fields.length === 1 && shape.method?.completes_later === false);
  const action = lasting.find((shape) => shape.object?.look === "wheels") ?? lasting[0] ?? actions[0];
  const bodies = all.filter((shape) => shape.kind === "constructor" && shape.flows.length > 0);
  const colours = (["choice", "loop", "parallel"] as const).map((colour) => {
    const same = bodies.filter((shape) => shape.colour === colour);
    // The one that asks for the least comes first.
    return same.toSorted((a, b) => a.plugs.length - b.plugs.length)[0];
  });
  return [action, ...colours].filter((shape) => shape !== undefined);
}

const MOST_LETTERS = 44;

/** The first sentence of a help text without its stop, or the beginning of it when it is long. */
function inShort(help: string): string {
  const sentence = firstSentence(help).replace(/[.۔]$/u, "");
  return sentence.length <= MOST_LETTERS ? sentence : (/^[^,;:،؛]*/u.exec(sentence)?.[0] ?? sentence);
}

export function EmptyTeaching({ drawing }: { drawing: Drawing }) {
  // The sheet for opening has the same.
  const choosing = useDocument((document) => document.overlay === "open");
  const start = drawing.structure.start?.id ?? "start";
  return (
    <section className="teaching">
      <h2>{t("graph.first-step")}</h2>
      <p>{t(hasCoarsePointer() ? "graph.first-tap" : "graph.first-help")}</p>
      <ul className="teaching-parts">
        {firstParts(drawing.parts).map((shape) => (
          <li key={shape.element}>
            <button
              type="button"
              data-testid={`first-${shape.element}`}
              onPointerDown={(event) => {
                beginDrag(event, { kind: "part", element: shape.element });
              }}
              onClick={() => {
                if (!justDragged()) addPartAt({ kind: "arc", source: start, out: "next" }, shape.element);
              }}
            >
              <Tile icon={shape.icon} colour={shape.colour} size={36} />
              <span>
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
