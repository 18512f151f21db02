/** Routes of custom blocks. */
import { ask } from "../../api/client";
import type { OfferAnswer, PartAnswer, PartRead, PartWish, Selected, Text } from "../../api/generated";
import type { Constructor, Mission } from "../../model/types";

export const partsApi = {
  offer: (selected: Selected) => ask<OfferAnswer>("part/offer", { method: "POST", json: selected }),
  make: (wish: PartWish) => ask<PartAnswer>("part", { method: "POST", json: wish }),
  read: (mission: Mission, path: string, robot: string, constructor: Constructor) =>
    ask<PartRead>("part/read", { method: "POST", json: { mission, path, robot, constructor } }),
  file: (constructors: readonly Constructor[]) => ask<Text>("part/file", { method: "POST", json: { constructors } }),
};
