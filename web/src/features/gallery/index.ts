/** What can be opened: missions of the folder, examples, recordings, work that was left. */
import { reportError, show } from "../../session/document";
import type { Feature } from "../../session/features";
import { later } from "../../ui/later";

const Examples = later(() => import("./Examples").then((chunk) => chunk.Examples), reportError, { words: false });
const OpenSheet = later(
  () => import("./OpenSheet").then((chunk) => chunk.OpenSheet),
  (cause) => {
    show(null);
    reportError(cause);
  },
);

declare module "../../session/document" {
  interface Overlays {
    open: true;
  }
}

export const gallery: Feature = {
  name: "gallery",
  panels: { "empty-program": Examples },
  sheets: { open: OpenSheet },
};
