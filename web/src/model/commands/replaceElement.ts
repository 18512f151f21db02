/** Makes another part of the same role of a vertex: EqualTo of LessThan, LightOn of LightOff. */
import { t } from "../../i18n/words";
import type { Command } from "../command";
import { fits, type Parts, title } from "../parts";
import { findSpot, newBlock } from "../tree";
import type { Program } from "../types";
import { editStructure } from "./edit";

/** The command, or null when that part cannot stand there. Fields and slots of the same name keep what they have. */
export function replaceElement(program: Program, parts: Parts, id: string, element: string): Command | null {
  const shape = parts.shape(element);
  return editStructure(t("command.change", { name: title(shape) }), program, parts, (structure) => {
    const spot = findSpot(structure, id);
    if (spot === undefined || spot.block.shape.element === element || spot.block.shape.role !== shape.role)
      return false;
    const { block } = spot;
    if (block.bodies.length > 0 || shape.flows.length > 0) return false;
    const fresh = newBlock(shape, id);
    for (const plug of fresh.plugs) {
      const filler = block.plugs.find((one) => one.slot === plug.slot)?.block ?? null;
      const wanted = shape.plugs.find((one) => one.name === plug.slot);
      if (filler !== null && wanted !== undefined && fits(filler.shape, wanted)) plug.block = filler;
    }
    const settings = Object.fromEntries(
      Object.entries(fresh.vertex.settings)
        .filter(([name]) => fresh.plugs.every((plug) => plug.slot !== name || plug.block === null))
        .map(([name, value]) => [name, block.vertex.settings[name] ?? value]),
    );
    block.vertex = { ...block.vertex, element, settings };
    block.shape = shape;
    block.plugs = fresh.plugs;
    return undefined;
  });
}
