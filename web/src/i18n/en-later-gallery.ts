/** English for the gallery and the sheet for opening, which are fetched later. */
export const GALLERY_EN = {
  "open.title": "Open a mission",
  "open.jumps": "Go to",
  "open.workspace": "In {folder}",
  "open.workspace-empty": "No mission in this folder yet.",
  "open.computer": "From this computer…",

  "gallery.find": "Find an example",
  "gallery.level": "How hard",
  "gallery.level-all": "All",
  "gallery.level-1": "Easy",
  "gallery.level-2": "Some practice",
  "gallery.level-3": "For experts",
  "gallery.level-0": "Others",
  "gallery.topic": "What about",
  "gallery.topic-all": "Everything",
  "gallery.robot": "Robot",
  "gallery.robot-all": "Any robot",
  "gallery.count": { one: "{count} example", other: "{count} examples" },
  "gallery.none": "No example is like that.",
  "gallery.show-all": "Show all examples",
  "gallery.move": "Pictures move",
} as const;
