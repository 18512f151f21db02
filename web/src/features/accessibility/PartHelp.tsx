/** F1: what a part is, from its XML: name, help, each value with its range, each slot. It is not modal. */
import { useEffect, useRef } from "react";

import { t } from "../../i18n/words";
import { inWords, storedNumber } from "../../model/meaning";
import { type Field, partsOf, type Shape, title } from "../../model/parts";
import { programInView, useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { isOwn, openDelete, openEdit } from "../../session/custom-blocks";
import { Tile } from "../../theme";
import { Button } from "../../ui/Button";
import { Tool } from "../../ui/Tool";
import { closeHelp, useAccessibility } from "./state";
import "../../ui/sheets.css";
import { borrowFocus } from "../../ui/borrow-focus";

export function PartHelp() {
  const element = useAccessibility((state) => state.explained);
  const robot = useStudio((state) => programInView(state)?.robot ?? "");
  const catalogue = useStudio((state) => state.catalogue);
  if (element === null) return null;
  const shape = element === "" ? null : partsOf(catalogue, robot).shape(element);
  return <Card key={element} shape={shape} />;
}

function Card({ shape }: { shape: Shape | null }) {
  const close = useRef<HTMLButtonElement>(null);
  useEffect(() => borrowFocus(close.current), []);
  return (
    <dialog
      className="sheet"
      open
      aria-labelledby="part-help-title"
      data-testid="part-help"
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        closeHelp();
      }}
    >
      <div className="sheet-body">
        <div className="sheet-head between aligned">
          {shape === null ? null : <Tile icon={shape.method?.icon || shape.icon} colour={shape.colour} />}
          <h2 id="part-help-title">{shape === null ? t("part-help.title") : title(shape)}</h2>
          <Tool small icon="x" label={t("help.close")} titled={false} ref={close} onClick={closeHelp} />
        </div>
        {shape === null ? <p>{t("part-help.how")}</p> : <Explained shape={shape} />}
      </div>
    </dialog>
  );
}

function helpOf(shape: Shape): string {
  if (shape.kind === "start") return t("inspector.start");
  if (shape.kind === "stop") return t("inspector.stop");
  return shape.kind === "unknown" ? t("inspector.unknown", { element: shape.element }) : text(shape.help);
}

/** "0 to 100 %, at first 50", or how a switch or text is set. */
function rangeOf(field: Field): string {
  if (field.kind === "text") return t("part-help.text");
  if (field.kind === "boolean") return t("part-help.switch");
  const [min, max, first] = [field.min, field.max, storedNumber(field.default) ?? 0].map((one) => inWords(field, one));
  return t("part-help.range", { min: min ?? "", max: max ?? "", first: first ?? "" });
}

function Explained({ shape }: { shape: Shape }) {
  const about = shape.object === null ? "" : text(shape.object.help);
  return (
    <div className="part-help">
      <p>{helpOf(shape)}</p>
      {about === "" ? null : <p>{about}</p>}
      <dl>
        {shape.fields.map((field) => (
          <div key={field.name}>
            <dt>{text(field.label, field.name)}</dt>
            <dd>
              {rangeOf(field)}
              {text(field.help) === "" ? null : <small className="block">{text(field.help)}</small>}
            </dd>
          </div>
        ))}
        {shape.plugs
          .filter((plug) => !shape.fields.some((field) => field.name === plug.name))
          .map((plug) => (
            <div key={plug.name}>
              <dt>{text(plug.label, plug.name)}</dt>
              <dd>{t(`part-help.${plug.accepts}`)}</dd>
            </div>
          ))}
        {shape.flows.map((flow) => (
          <div key={flow.name}>
            <dt>{text(flow.label, flow.name)}</dt>
            <dd>{t("part-help.body")}</dd>
          </div>
        ))}
      </dl>
      {isOwn(shape) ? <OwnActions name={shape.element} /> : null}
    </div>
  );
}

/** A part of one's own can be changed from here. */
function OwnActions({ name }: { name: string }) {
  const go = (to: (name: string) => void) => () => {
    closeHelp();
    to(name);
  };
  return (
    <div className="sheet-foot flex gap-m justify-end">
      <Button testId="help-delete" onClick={go(openDelete)}>
        {t("own.delete")}
      </Button>
      <Button testId="help-edit" onClick={go(openEdit)}>
        {t("own.edit")}
      </Button>
    </div>
  );
}
