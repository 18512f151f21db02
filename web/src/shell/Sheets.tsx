/** The panels that lie over the page, in a chunk of their own: none is there at first. */
import { DifferenceSheet } from "./DifferenceSheet";
import type { Overlay } from "./document";
import { AboutSheet } from "./HelpSheets";
import { OpenSheet } from "./OpenSheet";
import { SaveAsSheet } from "./SaveAsSheet";
import { ShortcutsSheet } from "./Shortcuts";

export function Sheets({ overlay }: { overlay: Overlay }) {
  switch (overlay) {
    case "open":
      return <OpenSheet />;
    case "save-as":
      return <SaveAsSheet />;
    case "shortcuts":
      return <ShortcutsSheet />;
    case "about":
      return <AboutSheet />;
    case "difference":
      return <DifferenceSheet />;
    case null:
      return null;
  }
}
