/** One vertex of a part as the canvas draws it, with its LLL below. */
import { useMemo } from "react";

import { GraphDrawing } from "../out/GraphDrawing";
import { layoutStructure } from "../model/layout";
import { partsOf } from "../model/parts";
import { readStructure } from "../model/structure";
import { findSpot } from "../model/tree";
import type { Catalogue, Program } from "../model/types";
import { lllExtensions } from "../code/extensions";
import { TextView } from "../code/TextView";
import { t } from "../words/words";

interface PreviewProps {
  catalogue: Catalogue;
  program: Program;
  vertex: string;
  title: string;
}

export function Preview({ catalogue, program, vertex, title }: PreviewProps) {
  const layout = useMemo(() => {
    const structure = readStructure(program, partsOf(catalogue, program.robot));
    const spot = findSpot(structure, vertex);
    if (spot === undefined) return null;
    const main = { out: "next", chain: [], closed: false };
    const alone = { ...structure, start: null, stop: null, main, parked: [[spot.block]], strays: [], lost: [] };
    const drawn = layoutStructure(alone);
    // It stands alone: no frame of what is parked, and nothing that is missing behind it.
    const arcs = drawn.arcs.filter(({ missing }) => !missing);
    return { ...drawn, frames: drawn.frames.filter(({ kind }) => kind !== "parked"), arcs };
  }, [catalogue, program, vertex]);
  if (layout === null) return null;
  return (
    <figure className="own-preview" data-testid="own-preview">
      <GraphDrawing layout={layout} title={title} inside="" />
    </figure>
  );
}

export function PartCode({ lll }: { lll: string }) {
  return (
    <div className="own-code" data-testid="own-lll">
      <TextView text={lll.trimEnd()} label={t("own.lll")} extensions={lllExtensions} />
    </div>
  );
}
