/** The sign at the edge of a vertex that a run pauses there: full when it is on, hollow when it is off. */
import "./breakpoint-sign.css";

import { t } from "../../i18n/words";
import type { LayoutNode } from "../../model/layout";
import { useBreakpoint } from "../../session/breakpoints";
import { useRun } from "../../session/run";

export function BreakpointSign({ node }: { node: LayoutNode }) {
  const breakpoint = useBreakpoint(node);
  const reached = useRun(({ hits }) => hits.some((hit) => hit.vertex === breakpoint?.vertex));
  if (breakpoint === undefined) return null;
  const { when = "", hits = 1, enabled = true, agents = [] } = breakpoint;
  const says = [
    t(enabled ? "debug.breakpoint" : "debug.breakpoint-off"),
    when === "" ? "" : t("debug.says-when", { when }),
    hits === 1 ? "" : t("debug.says-hits", { hits }),
    agents.length === 0 ? "" : agents.join(", "),
  ];
  const label = says.filter((one) => one !== "").join(" · ");
  return (
    <span
      className="breakpoint"
      role="img"
      aria-label={label}
      title={label}
      data-testid={`breakpoint-${node.vertex}`}
      data-off={!enabled}
      data-more={when !== "" || hits !== 1 || agents.length > 0}
      data-reached={reached}
    />
  );
}
