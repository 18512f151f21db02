/** What can be set on the selected part. */
import "./inspector.css";

import { useEffect } from "react";

import { handKey } from "../../i18n/touch";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { findSpot } from "../../model/tree";
import { reportError } from "../../session/document";
import { useDrawing } from "../../session/drawing";
import { Icon } from "../../theme";
import { later } from "../../ui/later";
import { Tools } from "./Tools";

const Part = later(() => import("./Part").then((chunk) => chunk.Part), reportError);

export function Inspector() {
  const drawing = useDrawing();
  const selection = useStudio((state) => state.selection);
  const [id] = selection;
  useEffect(() => {
    // What scrolls is around it: another part begins at its top. In the next frame the browser lays out the page anyway.
    const frame = requestAnimationFrame(() => document.querySelector(".side-inspector")?.scrollTo({ top: 0 }));
    return () => cancelAnimationFrame(frame);
  }, [id, drawing?.program.name]);
  if (drawing === null || id === undefined) return <Nothing />;
  if (selection.length > 1) return <Many count={selection.length} />;
  const { start, stop } = drawing.structure;
  if (id === start?.id) return <Terminal name={t("graph.start")} help={t("inspector.start")} />;
  if (id === stop?.id) return <Terminal name={t("graph.stop")} help={t("inspector.stop")} />;
  const spot = findSpot(drawing.structure, id);
  return spot === undefined ? (
    <Nothing />
  ) : (
    <Part key={`${drawing.program.name} ${id}`} drawing={drawing} spot={spot} />
  );
}

function Nothing() {
  return (
    <div className="inspector column">
      <header className="inspector-head row">
        <h2>{t("inspector.title")}</h2>
      </header>
      <div className="inspector-nothing muted flex">
        <Icon name="mouse-pointer-2" size={18} />
        <p>
          <strong>{t("inspector.nothing")}</strong>
          {t(handKey("inspector.nothing-help"))}
        </p>
      </div>
    </div>
  );
}

function Terminal({ name, help }: { name: string; help: string }) {
  return (
    <div className="inspector column">
      <header className="inspector-head row">
        <h2>{name}</h2>
      </header>
      <p className="inspector-help muted small-text below prose">{help}</p>
    </div>
  );
}

function Many({ count }: { count: number }) {
  return (
    <div className="inspector column">
      <header className="inspector-head row">
        <h2>{t("inspector.many", { count })}</h2>
        <Tools />
      </header>
    </div>
  );
}
