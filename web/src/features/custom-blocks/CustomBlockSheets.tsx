/** The sheets about parts of one's own, in a chunk that is fetched when the first one is opened. */
import "./custom-blocks.css";

import type { OwnSheet } from "../../session/custom-blocks";
import { DeleteSheet } from "./DeleteSheet";
import { EditSheet } from "./EditSheet";
import { SaveSheet } from "./SaveSheet";

export function CustomBlockSheets({ sheet }: { sheet: OwnSheet }) {
  switch (sheet.kind) {
    case "save":
      return <SaveSheet program={sheet.program} vertices={sheet.vertices} />;
    case "edit":
      return <EditSheet key={sheet.name} name={sheet.name} />;
    case "delete":
      return <DeleteSheet name={sheet.name} />;
  }
}
