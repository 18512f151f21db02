/** Recordings: played, saved, run again. */
export const RECORDING_EN = {
  "recording.playing": "You are watching a recording: {name}, seed {seed}.",
  "recording.real": "You are watching a recording of a real robot: {name}.",
  "recording.live": "Now the mission of the recording {name} runs anew, with seed {seed}.",
  "recording.nothing": "Go back and on in it as you like; nothing in it can be changed.",
  "recording.breakpoints":
    "It pauses at a part marked “Pause here” where it shows that a robot was there: where one stood, or gave a command that no other part can give.",
  "recording.cut": "Its file was cut off: it ends before its run did.",
  "recording.run": "Run this mission",
  "recording.again": "Play it again",
  "recording.play": "Back to the recording",
  "recording.save": "Save this run…",
  "recording.title": "from a recording",
  "recording.list": "Recordings in {folder}",
  "status.end": "The recording ends here",
  "strip.outside": "by hand",
} as const;
