/** Where a Break leads: lines on lanes of their own. They are to be seen, not to be dropped on (model/layout/break-edges.ts). */
import { memo } from "react";

import { headPath, type LayoutLeap, roundedPath } from "../../model/layout";

export const Leaps = memo(function Leaps({ leaps }: { leaps: readonly LayoutLeap[] }) {
  return leaps.map(({ source, points, colour, label }) => {
    const path = roundedPath(points, true);
    const head = headPath(points);
    return (
      <g key={source} className="arc leap passive" data-colour={colour} data-testid={`leap-${source}`}>
        <path className="arc-line" d={path} style={{ d: `path("${path}")` }} />
        <path className="arc-head" d={head} style={{ d: `path("${head}")` }} />
        <text
          className="arc-label"
          style={{ transform: `translate(${String(label.x)}px, ${String(label.y)}px)` }}
          textAnchor={label.anchor}
          dominantBaseline="central"
        >
          {label.text}
        </text>
      </g>
    );
  });
});
