/** Recordings: played, saved, run again. */
export const RECORDING_EN = {
  "recording.save": "Save this run…",
  "recording.title": "from a recording",
  "status.end": "The recording ends here",
  "strip.outside": "by hand",
} as const;
