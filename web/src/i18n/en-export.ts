/** English for what leaves the studio: files to keep and the printed sheet. */
import type { Sentence } from "./words";

export const EXPORT_EN = {
  "out.download-kri": "Download image of {name} (.kri)",
  "out.download-kra": "Download three-address code of {name} (.kra)",
  "out.download-tree": "Download behaviour tree of {name} (.xml)",
  "out.no-image": "“{name}” has errors, so there is no image of it yet.",
  "out.no-image-help": "Mend what the list of problems shows; F8 goes to the next one.",
  "out.show-problem": "Show the error",
  "out.export-pdf": "Export as PDF…",
  "out.print": "Print…",
  "out.print-failed": "The sheet could not be made: load the page again.",
} as const satisfies Record<string, Sentence>;
