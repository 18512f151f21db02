/** One vertex of a part as the canvas draws it, with its LLL below. */
import { useMemo } from "react";

import { GraphDrawing } from "../../components/graph/GraphDrawing";
import { lllExtensions } from "../../components/text/extensions";
import { TextView } from "../../components/text/TextView";
import { t } from "../../i18n/words";
import { type Box, boundsOf, layoutStructure } from "../../model/layout";
import { partsOf } from "../../model/parts";
import { readStructure } from "../../model/structure";
import { findSpot } from "../../model/tree";
import type { Catalogue, Program } from "../../model/types";

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
    const frames = drawn.frames.filter(({ kind }) => kind !== "parked");
    return { ...drawn, frames, arcs, bounds: boundsOf([...drawn.nodes, ...frames, ...arcs.flatMap(around)]) };
  }, [catalogue, program, vertex]);
  if (layout === null) return null;
  return (
    <figure className="own-preview scroll text-centre" data-testid="own-preview">
      <GraphDrawing layout={layout} title={title} inside="" />
    </figure>
  );
}

/** The points of an arc, as boxes without size. */
function around({ points }: { points: readonly { x: number; y: number }[] }): Box[] {
  return points.map(({ x, y }) => ({ x, y, w: 0, h: 0 }));
}

export function PartCode({ lll }: { lll: string }) {
  return (
    <div className="own-code small-text scroll typed" data-testid="own-lll">
      <TextView text={lll.trimEnd()} label={t("own.lll")} extensions={lllExtensions} />
    </div>
  );
}
