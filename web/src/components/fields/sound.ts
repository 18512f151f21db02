/** One short tone, quietly. */

const MS = 300;
const LOUD = 0.05;
/** What can be heard, in Hz. */
const [LOWEST, HIGHEST] = [20, 20_000];

let context: AudioContext | null = null;

export function sound(hz: number): void {
  if (typeof AudioContext === "undefined" || hz < LOWEST || hz > HIGHEST) return;
  context ??= new AudioContext();
  const oscillator = context.createOscillator();
  const gain = context.createGain();
  const now = context.currentTime;
  oscillator.type = "triangle";
  oscillator.frequency.setValueAtTime(hz, now);
  gain.gain.setValueAtTime(LOUD, now);
  gain.gain.setTargetAtTime(0, now + MS / 1000, 0.03);
  oscillator.connect(gain).connect(context.destination);
  oscillator.start(now);
  oscillator.stop(now + MS / 1000 + 0.2);
}
