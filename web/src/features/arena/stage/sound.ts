/**
 * What robots sound: tones and melodies of their buzzers, and horns of their own devices, quietly, in this page.
 *
 * A run that pauses, is gone through by hand or goes faster than eight times is silent. Of several robots each has a voice,
 * up to `VOICES`.
 */
import { useEffect } from "react";

import { indicatorsOf } from "../../../components/scene/boards";
import type { Robot } from "../../../model/types";
import { useStudio } from "../../../model/studio";
import { useRun } from "../../../session/run";
import { type Note, notesOf } from "./melodies";

const VOICES = 4;
const LOUD = 0.05;
const FASTEST = 8;
const HORN: readonly Note[] = [
  { hz: 392, ms: 120 },
  { hz: 330, ms: 180 },
];
/** What can be heard, in Hz. */
const [LOWEST, HIGHEST] = [20, 20_000];

/** What a robot sounds now: "" for nothing, a tone, a melody by its number, or its horn. */
export function soundOf(robot: Robot | undefined, shown: Readonly<Record<string, readonly number[]>>): string {
  for (const { name, look } of robot?.objects ?? []) {
    if (look !== "melody") continue;
    const [hz = 0, melody = 0] = shown[name] ?? [];
    if (melody > 0) return `melody ${String(melody - 1)}`;
    if (hz >= LOWEST && hz <= HIGHEST) return `tone ${String(hz)}`;
  }
  return indicatorsOf(robot, shown).some(({ look, share }) => look === "sound" && share > 0) ? "horn" : "";
}

class Voice {
  private sound = "";
  private oscillator: OscillatorNode | null = null;
  private gain: GainNode | null = null;

  play(context: AudioContext, sound: string, speed: number): void {
    if (sound === this.sound) return;
    this.hush(context);
    this.sound = sound;
    if (sound === "") return;
    const oscillator = context.createOscillator();
    const gain = context.createGain();
    oscillator.type = "triangle";
    oscillator.connect(gain).connect(context.destination);
    const [kind, number = "0"] = sound.split(" ");
    let at = context.currentTime;
    const notes = kind === "tone" ? [{ hz: Number(number), ms: 0 }] : kind === "horn" ? HORN : notesOf(Number(number));
    gain.gain.setValueAtTime(0, at);
    for (const { hz, ms } of notes) {
      const end = at + ms / 1000 / speed;
      oscillator.frequency.setValueAtTime(Math.max(hz, LOWEST), at);
      gain.gain.setTargetAtTime(hz > 0 ? LOUD : 0, at, 0.008);
      // A short gap tells two equal notes apart.
      if (ms > 0) gain.gain.setTargetAtTime(0, end - 0.03 / speed, 0.008);
      at = end;
    }
    oscillator.start();
    if (kind !== "tone") oscillator.stop(at + 0.1);
    [this.oscillator, this.gain] = [oscillator, gain];
  }

  hush(context: AudioContext): void {
    this.sound = "";
    if (this.gain !== null) {
      this.gain.gain.cancelScheduledValues(context.currentTime);
      this.gain.gain.setTargetAtTime(0, context.currentTime, 0.01);
    }
    this.oscillator?.stop(context.currentTime + 0.1);
    [this.oscillator, this.gain] = [null, null];
  }
}

/** Lets the run be heard while `on`. */
export function useSound(on: boolean): void {
  useEffect(() => {
    if (!on || typeof AudioContext === "undefined") return;
    let context: AudioContext | null = null;
    const voices = new Map<string, Voice>();
    const hear = () => {
      const { agents, status, speed, watching } = useRun.getState();
      const heard = status === "running" && speed > 0 && speed <= FASTEST && !watching;
      const { robots } = useStudio.getState().catalogue;
      for (const { name, robot, shown } of agents) {
        const sound = heard
          ? soundOf(
              robots.find((one) => one.name === robot),
              shown,
            )
          : "";
        const voice = voices.get(name);
        if (sound === "" && voice === undefined) continue;
        if (voice === undefined && voices.size >= VOICES) continue;
        context ??= new AudioContext();
        const own = voice ?? new Voice();
        if (sound === "") {
          own.hush(context);
          voices.delete(name);
        } else {
          voices.set(name, own);
          own.play(context, sound, speed);
        }
      }
    };
    hear();
    const off = useRun.subscribe((now, before) => {
      if (now.agents !== before.agents || now.status !== before.status || now.speed !== before.speed) hear();
    });
    return () => {
      off();
      if (context === null) return;
      for (const voice of voices.values()) voice.hush(context);
      void context.close();
    };
  }, [on]);
}
