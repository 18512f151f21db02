/**
 * The twelve melodies of `Music.Play`, by their numbers, as notes: letter, sharp or not, octave, then how many beats.
 *
 * How long each takes is the simulator's: the notes are stretched to that, so that sound and program end together.
 */

export interface Note {
  /** 0 is silence. */
  hz: number;
  ms: number;
}

/** As in `sim/devices/music.py`, in ms. */
export const LENGTHS_MS = [1125, 1125, 625, 625, 500, 2625, 4000, 3375, 16_000, 12_000, 2750, 2625] as const;

const ODE = "e4 e4 f4 g4 g4 f4 e4 d4 c4 c4 d4 e4";
const TUNES: readonly string[] = [
  "c4 e4 g4 c5 e5 g5 c6:2",
  "c6 g5 e5 c5 g4 e4 c4:2",
  "c5 d5 e5 f5 g5",
  "g5 f5 e5 d5 c5",
  "b5 e6:3",
  "e4:3 d#4:3 d4:3 c#4:8",
  "g4 g4 g4 d#4:6 r f4 f4 f4 d4:7",
  "d4 d#4 e4 c5:2 e4 c5:2 e4 c5:4",
  `${ODE} e4:1.5 d4:0.5 d4:2 ${ODE} d4:1.5 c4:0.5 c4:2`,
  "c4 c4 d4:2 c4:2 f4:2 e4:4 c4 c4 d4:2 c4:2 g4:2 f4:4 c4 c4 c5:2 a4:2 f4:2 e4:2 d4:2 a#4 a#4 a4:2 f4:2 g4:2 f4:4",
  "c5 d5 g5:2 r c5 d5 g5:2 r c5 d5 g5:2",
  "c4:3 g4 f#4 g4 g#4:3 g4:3 r:2 b4 c5:3",
];
const SEMITONES: Readonly<Record<string, number>> = { c: 0, d: 2, e: 4, f: 5, g: 7, a: 9, b: 11 };

function hzOf(name: string): number {
  const [, letter = "", sharp = "", octave = "4"] = /^([a-g])(#?)(\d)$/.exec(name) ?? [];
  const tone = SEMITONES[letter];
  return tone === undefined ? 0 : 440 * 2 ** ((tone + sharp.length + 12 * (Number(octave) - 4) - 9) / 12);
}

/** The notes of a melody; a larger number is the last one. */
export function notesOf(melody: number): Note[] {
  const at = Math.min(Math.max(Math.trunc(melody), 0), TUNES.length - 1);
  const notes = (TUNES[at] ?? "").split(" ").map((word) => {
    const [name = "", beats = "1"] = word.split(":");
    return { hz: hzOf(name), beats: Number(beats) };
  });
  const beats = notes.reduce((sum, note) => sum + note.beats, 0);
  return notes.map((note) => ({ hz: note.hz, ms: ((LENGTHS_MS[at] ?? 1000) * note.beats) / beats }));
}
