/** English for parts of one's own: saving, editing, deleting them. */
export const CUSTOM_BLOCKS_EN = {
  "own.save": "Save as a part…",
  "own.edit": "Edit this part…",
  "own.delete": "Delete this part…",
  "own.share": "Download my parts",
  "own.menu": "{name}: what to do",
  "own.command-save": "Save {name} as a part",
  "own.command-dissolve": "Dissolve {name}",
  "own.key": "Save the selection as a part",
} as const;
