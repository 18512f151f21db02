/** Deletes vertices with all they hold; arcs heal, a marked action takes its mark along. */
import { t } from "../../i18n/words";
import type { Command } from "../command";
import { type Parts, title } from "../parts";
import { findSpot, inChain, takeOut, topmost, withMark } from "../tree";
import type { Program } from "../types";
import { editStructure } from "./edit";

/** The command, or null when nothing of it can be deleted (Start and Stop stay). Selects what is then in that place. */
export function deleteParts(program: Program, parts: Parts, ids: string[]): Command | null {
  const elements = ids.map((id) => program.vertices.find((one) => one.id === id)?.element ?? "");
  const name = ids.length === 1 ? title(parts.shape(elements[0] ?? "")) : t("command.parts");
  return editStructure(t("command.delete", { name }), program, parts, (structure) => {
    const spots = topmost(structure, ids).map(withMark);
    const [first] = spots;
    if (first === undefined) return false;
    const neighbour = nextTo(structure, first);
    for (const spot of spots) takeOut(structure, spot);
    return neighbour !== undefined && findSpot(structure, neighbour) !== undefined ? [neighbour] : [];
  });
}

function nextTo(structure: Parameters<typeof takeOut>[0], spot: ReturnType<typeof withMark>): string | undefined {
  if (spot.kind === "slot") return spot.owner.block.vertex.id;
  const { chain, index, owner } = inChain(spot);
  const neighbour = chain[index - 1] ?? chain[index + 1] ?? owner?.block;
  const held = neighbour?.plugs.length === 1 && neighbour.bodies.length === 0 ? neighbour.plugs[0]?.block : null;
  return (held ?? neighbour)?.vertex.id ?? structure.main.chain[0]?.vertex.id;
}
