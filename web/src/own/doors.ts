/** The server's doors to parts of one's own. */
import { ask } from "../api/client";
import type { Chosen, OfferAnswer, PartAnswer, PartRead } from "../api/generated";
import type { Colour, Constructor, Mission, Texts } from "../model/types";

/** A selection of a program of the open mission. */
export interface Selected {
  mission: Mission;
  path: string;
  program: string;
  vertices: string[];
}

export interface Wish extends Selected {
  name: string;
  icon: string;
  colour: Colour;
  label: Texts;
  help: Texts;
  chosen: Chosen[];
}

export const partsApi = {
  offer: (selected: Selected) => ask<OfferAnswer>("part/offer", { method: "POST", json: selected }),
  make: (wish: Wish) => ask<PartAnswer>("part", { method: "POST", json: wish }),
  read: (mission: Mission, path: string, robot: string, constructor: Constructor) =>
    ask<PartRead>("part/read", { method: "POST", json: { mission, path, robot, constructor } }),
  file: (constructors: readonly Constructor[]) =>
    ask<{ text: string }>("part/file", { method: "POST", json: { constructors } }),
};
