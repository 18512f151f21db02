/** Files to keep and sheets to print; what makes them is fetched on demand. */
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { reportError, show } from "../../session/document";
import type { Feature } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import type { MenuEntries } from "../../session/menu-table";
import { later } from "../../ui/later";
import { menuItem } from "../../ui/menu-model";
import { preparePrinting, printSheet } from "./print";

const pictures = () => import("./pictures");
const images = () => import("./images");
const PdfSheet = later(
  () => import("./PdfSheet").then((chunk) => chunk.PdfSheet),
  (cause) => {
    show(null);
    reportError(cause);
  },
);

declare module "../../session/document" {
  interface Overlays {
    pdf: true;
  }
}

const KEYS = {
  print: { chords: ["Ctrl+P"], says: "out.print", typing: true, run: printSheet },
} satisfies Record<string, PageKey>;

function useMenu(): MenuEntries {
  const program = useStudio((studio) => studio.activeProgram);
  const kri = t("out.download-kri", { name: program });
  const kra = t("out.download-kra", { name: program });
  const tree = t("out.download-tree", { name: program });
  return {
    image: [
      menuItem("file-download-kri", kri, null, () => images().then((out) => out.downloadImage())),
      menuItem("file-download-kra", kra, null, () => images().then((out) => out.downloadListing())),
      menuItem("file-download-tree", tree, null, () => images().then((out) => out.downloadTree())),
    ],
    picture: [
      menuItem("file-export-svg", t("file.export-svg"), null, () => pictures().then((out) => out.exportSvg())),
      menuItem("file-export-png", t("file.export-png"), null, () => pictures().then((out) => out.exportPng())),
      menuItem("file-export-pdf", t("out.export-pdf"), null, () => {
        show("pdf");
      }),
    ],
    print: [menuItem("file-print", t("out.print"), keyFor.page(KEYS.print), printSheet)],
  };
}

export const exporting: Feature = {
  name: "export",
  keys: KEYS,
  words: {
    "file-download-kri": "search.binary",
    "file-download-kra": "search.listing",
    "file-download-tree": "search.behaviour-tree",
    "file-export-svg": "search.picture",
    "file-export-png": "search.picture",
  },
  useMenu,
  sheets: { pdf: PdfSheet },
  start: preparePrinting,
};
