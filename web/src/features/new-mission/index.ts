/** A new mission begins with pictures: which robot, in which place, with which first program. */
import { reportError, show } from "../../session/document";
import type { Feature } from "../../session/features";
import { later } from "../../ui/later";

const NewMission = later(
  () => import("./NewMission").then((chunk) => chunk.NewMission),
  (cause) => {
    show(null);
    reportError(cause);
  },
  { words: false },
);

declare module "../../session/document" {
  interface Overlays {
    new: true;
  }
}

export const newMission: Feature = { name: "new-mission", sheets: { new: NewMission } };
