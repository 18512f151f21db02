/** The rows of a block: one for each value that is typed in, one for each slot, and below a slot what fills it. */
import { FieldRow } from "../../components/fields/FieldRow";
import { t } from "../../i18n/words";
import type { Command } from "../../model/command";
import { deleteParts } from "../../model/commands/deleteParts";
import { insertPart } from "../../model/commands/insertPart";
import { replaceElement } from "../../model/commands/replaceElement";
import { type Field, fieldOf, fits, type Parts, type Plug, type Shape, title } from "../../model/parts";
import type { Block } from "../../model/structure";
import { execute, useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import type { Spot } from "../../model/tree";
import { wordsOf } from "../../model/words";
import type { Drawing } from "../../session/drawing";
import { useShown } from "../../session/simple-view";
import { addressOf, toggleVaried, useVaried } from "../../session/varied-axes";
import { Row } from "../../ui/Row";
import { Tool } from "../../ui/Tool";

/** Runs a command and leaves the selection where it is. */
function runHere(command: Command | null): void {
  if (command !== null) execute({ ...command, selects: useStudio.getState().selection });
}

export function BlockEditor({ drawing, spot }: { drawing: Drawing; spot: Spot }) {
  const { block } = spot;
  const plug = spot.kind === "slot" ? spot.owner.block.shape.plugs.find((one) => one.name === spot.slot) : undefined;
  return (
    <div>
      {spot.kind === "slot" && plug !== undefined && plug.accepts !== "action" ? (
        <SlotRow drawing={drawing} owner={spot.owner.block} plug={plug} label={t("inspector.method")} />
      ) : null}
      <Rows drawing={drawing} block={block} />
    </div>
  );
}

function Rows({ drawing, block }: { drawing: Drawing; block: Block }) {
  const { shape } = block;
  const slots = shape.plugs.filter((plug) => fieldOf(shape, plug.name) === undefined);
  return (
    <>
      {shape.fields.map((field) => (
        <ValueRow key={field.name} drawing={drawing} block={block} field={field} />
      ))}
      {slots.map((plug) => (
        <SlotRow key={plug.name} drawing={drawing} owner={block} plug={plug} label={text(plug.label, plug.name)}>
          <Filler drawing={drawing} owner={block} plug={plug} />
        </SlotRow>
      ))}
    </>
  );
}

/** What fills a slot, indented under it. */
function Filler({ drawing, owner, plug }: { drawing: Drawing; owner: Block; plug: Plug }) {
  const filler = owner.plugs.find((one) => one.slot === plug.name)?.block ?? null;
  if (filler === null || (filler.shape.fields.length === 0 && filler.shape.plugs.length === 0)) return null;
  return (
    <div className="inspector-inner">
      <Rows drawing={drawing} block={filler} />
    </div>
  );
}

/** A value: typed in, or what is plugged in its place. */
function ValueRow({ drawing, block, field }: { drawing: Drawing; block: Block; field: Field }) {
  const { program, parts } = drawing;
  const filler = block.plugs.find((plug) => plug.slot === field.name)?.block ?? null;
  if (filler === null)
    return (
      <>
        <FieldRow drawing={drawing} vertex={block.vertex} field={field} />
        {field.kind === "integer" ? (
          <VaryButton
            address={addressOf(program.name, block.vertex.id, field.name)}
            name={text(field.label, field.name)}
          />
        ) : null}
      </>
    );
  return (
    <div className="field-row row">
      <span className="field-label rigid">{text(field.label, field.name)}</span>
      <span className="muted grow">{t("inspector.from-value", { what: wordsOf(filler) })}</span>
      <Tool
        small
        icon="x"
        label={t("inspector.type-instead")}
        onClick={() => runHere(deleteParts(program, parts, [filler.vertex.id]))}
      />
    </div>
  );
}

interface SlotRowProps {
  drawing: Drawing;
  owner: Block;
  plug: Plug;
  label: string;
  children?: React.ReactNode;
}

/** A slot with the list of everything that fits it. */
function SlotRow({ drawing, owner, plug, label, children }: SlotRowProps) {
  const { program, parts } = drawing;
  const filler = owner.plugs.find((one) => one.slot === plug.name)?.block ?? null;
  const known = parts.all.filter((shape) => fits(shape, plug));
  const choose = (element: string) => {
    if (element === "") {
      if (filler !== null) runHere(deleteParts(program, parts, [filler.vertex.id]));
      return;
    }
    const shape = parts.shape(element);
    const swaps = filler?.shape.kind === "method" && shape.kind === "method";
    const place = { kind: "slot", vertex: owner.vertex.id, slot: plug.name } as const;
    runHere(
      swaps ? replaceElement(program, parts, filler.vertex.id, element) : insertPart(program, parts, place, element),
    );
  };
  return (
    <>
      <Row label={label} className="field-row" labelClass="field-label rigid">
        <select
          className="field"
          data-inspector-field=""
          data-testid={`choose-${owner.vertex.id}.${plug.name}`}
          value={filler?.shape.element ?? ""}
          onChange={(event) => choose(event.target.value)}
        >
          <option value="">{filler === null ? t("inspector.choose") : t("inspector.clear")}</option>
          {groupsOf(known, parts).map(([group, shapes]) => (
            <optgroup key={group} label={group}>
              {shapes.map((shape) => (
                <option key={shape.element} value={shape.element}>
                  {optionWords(shape)}
                </option>
              ))}
            </optgroup>
          ))}
          {filler !== null && !known.includes(filler.shape) ? (
            <option value={filler.shape.element}>{filler.shape.element}</option>
          ) : null}
        </select>
      </Row>
      {children}
    </>
  );
}

/** What the robot feels first; And, Or and Not, which need a test themselves, after it. */
function groupsOf(shapes: Shape[], parts: Parts): [string, Shape[]][] {
  const named = (shape: Shape) => {
    const { object, constructor_ } = shape;
    if (object !== null) return text(object.label, object.name);
    const group = parts.groups.find(({ name }) => name === constructor_?.group);
    return group === undefined ? "" : text(group.label, group.name);
  };
  const groups = new Map<string, Shape[]>();
  const [felt, made] = [shapes.filter(({ object }) => object !== null), shapes.filter(({ object }) => object === null)];
  for (const shape of [...felt, ...made]) groups.set(named(shape), [...(groups.get(named(shape)) ?? []), shape]);
  return [...groups];
}

/** A test as it will read, its numbers still open: "Sign = …". */
function optionWords(shape: Shape): string {
  const phrase = text(shape.method?.phrase ?? {});
  if (phrase === "" || shape.object === null) return title(shape);
  const object = text(shape.object.label, shape.object.name);
  return phrase.replace(/\{([^}]*)\}/g, (_, hole: string) => (hole === "object" ? object : "…"));
}

/** Marks a number to vary in an experiment, and says its address, as the command line takes it, with the values. */
function VaryButton({ address, name }: { address: string; name: string }) {
  const axis = useVaried(({ axes }) => axes.find((one) => one.address === address));
  if (!useShown("verification")) return null;
  return (
    <div className="row small-text justify-end">
      <button
        type="button"
        className="inspector-vary-button finger muted boxed"
        aria-pressed={axis !== undefined}
        title={`${t("experiment.vary-part")}: ${address}`}
        aria-label={t(axis === undefined ? "experiment.vary-field" : "experiment.varied-field", { name })}
        data-testid={`vary-${address}`}
        onClick={() => toggleVaried(address)}
      >
        {t("experiment.vary")}
      </button>
      {axis === undefined ? null : (
        <code className="ellipsis" dir="ltr">
          {axis.values === "" ? address : `${address}=${axis.values}`}
        </code>
      )}
    </div>
  );
}
