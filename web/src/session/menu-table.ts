/**
 * The menus of the bar and the groups of entries in them, in their order. A feature names the group that its entries go
 * into; within a group they stand in the order of `app/features.ts`. Sections that have entries are divided by lines.
 */
import type { MenuEntry } from "../ui/menu-model";

export const MENUS = [
  {
    id: "File",
    label: "menu.file",
    sections: [["open", "add"], ["save"], ["download", "image"], ["picture"], ["print"]],
  },
  { id: "Edit", label: "menu.edit", sections: [["history"], ["clipboard"], ["find"]] },
  { id: "View", label: "menu.view", sections: [["simple"], ["viewport", "look", "outline"]] },
  {
    id: "Program",
    label: "menu.program",
    sections: [["new-program"], ["custom-blocks"], ["team", "variable"], ["program"]],
  },
  { id: "Run", label: "menu.run", sections: [["run"], ["sweep"]] },
  { id: "Robots", label: "menu.robots", sections: [["robots-panel"], ["robots"]] },
  { id: "Help", label: "menu.help", sections: [["tutorials"], ["part", "help"]] },
] as const;

export type MenuGroup = (typeof MENUS)[number]["sections"][number][number];

/** Entries by the group that they go into. */
export type MenuEntries = Partial<Record<MenuGroup, MenuEntry[]>>;
