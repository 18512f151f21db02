/** The sheets of the page itself, in a chunk of their own: none is open at first. */
export { DifferenceSheet } from "./DifferenceSheet";
export { AboutSheet } from "./HelpSheets";
export { SaveAsSheet } from "./SaveAsSheet";
export { ShortcutsSheet } from "./Shortcuts";
