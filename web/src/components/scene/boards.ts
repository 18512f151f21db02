/**
 * What a robot shows and where a person can lay a hand on it, read from its devices: a display with its lights, a buzzer,
 * pins; keys and the like that somebody holds.
 *
 * How a board is drawn is in `draw-board.ts`, which is fetched when one is there; what a hand does in `hands.ts`.
 */
import { text } from "../../model/texts";
import type { Robot, RobotObject } from "../../model/types";

export interface HandKey {
  sensor: string;
  label: string;
  /** The key of the keyboard that holds it; "" for none. */
  letter: string;
  pressed: boolean;
  /** Whether it is a button on the board itself, not something done to the whole of it. */
  onBoard: boolean;
}

export interface Slider {
  sensor: string;
  label: string;
  value: number;
  min: number;
  max: number;
}

/** A value that an actuator shows beside its robot; `share` is where it lies between nothing (0) and its largest (1). */
export interface Indicator {
  label: string;
  look: "lamp" | "bar" | "sound" | "number";
  value: number;
  share: number;
}

export interface Face {
  /** Five rows of five decimal digits, each a light from 0 to 9. */
  rows: readonly number[];
  sounds: boolean;
  /** Of each pin that is told something: how much, from 0 to 1. */
  pins: readonly number[];
}

interface Parts {
  display: RobotObject | undefined;
  music: readonly RobotObject[];
  pins: readonly RobotObject[];
  hands: readonly RobotObject[];
  sliders: readonly RobotObject[];
  indicators: readonly { part: RobotObject; look: Indicator["look"]; least: number; most: number }[];
}

const DARK = [0, 0, 0, 0, 0];
/** The largest number of a pin: written, analogue, servo. */
const MOST = [1, 1, 1023, 180];

const known = new WeakMap<Robot, Parts>();

function partsOf(robot: Robot): Parts {
  const before = known.get(robot);
  if (before !== undefined) return before;
  const looking = (look: RobotObject["look"]) => robot.objects.filter((one) => one.look === look);
  const parts = {
    display: looking("lights")[0],
    music: looking("melody"),
    pins: looking("pin"),
    hands: robot.objects.filter(({ hand }) => hand === "button" || hand === "gesture"),
    sliders: robot.objects.filter(({ hand }) => hand === "slider"),
    indicators: robot.objects.flatMap((one) => {
      const { look } = one;
      if (look !== "lamp" && look !== "bar" && look !== "sound" && look !== "number") return [];
      const ranges = one.methods.flatMap(({ parameters }) => parameters.slice(0, 1));
      const least = Math.min(0, ...ranges.map(({ min }) => min));
      const most = ranges.length === 0 ? 1 : Math.max(least + 1, ...ranges.map(({ max }) => max));
      return [{ part: one, look, least, most }];
    }),
  };
  known.set(robot, parts);
  return parts;
}

/** ButtonA → A, Shake → S: the last capital letter at an end, else the first letter. */
export function letterOf(name: string): string {
  const last = /[a-z_](\p{Lu})$/u.exec(name)?.[1];
  return (last ?? name.charAt(0)).toUpperCase();
}

const NO_KEYS: HandKey[] = [];

/** What a person can hold; of two with one letter the first has it. */
export function keysOf(robot: Robot | undefined, inputs: Readonly<Record<string, number>>): HandKey[] {
  if (robot === undefined) return NO_KEYS;
  const { hands } = partsOf(robot);
  if (hands.length === 0) return NO_KEYS;
  const taken = new Set<string>();
  return hands.map(({ name, label, hand }) => {
    const letter = letterOf(name);
    const free = !taken.has(letter);
    taken.add(letter);
    return {
      sensor: name,
      label: text(label, name),
      letter: free ? letter : "",
      pressed: (inputs[name] ?? 0) !== 0,
      onBoard: hand === "button",
    };
  });
}

/** The sensors that a person sets; before a run they stand at their initial numbers. */
export function slidersOf(robot: Robot | undefined, inputs: Readonly<Record<string, number>>): Slider[] {
  if (robot === undefined) return [];
  return partsOf(robot).sliders.map(({ name, label, min, max, initial }) => {
    const value = Math.min(Math.max(inputs[name] ?? initial, min), max);
    return { sensor: name, label: text(label, name), value, min, max };
  });
}

/** What actuators show beside a robot. */
export function indicatorsOf(
  robot: Robot | undefined,
  shown: Readonly<Record<string, readonly number[]>>,
): Indicator[] {
  if (robot === undefined) return [];
  return partsOf(robot).indicators.map(({ part: { name, label }, look, least, most }) => {
    const value = shown[name]?.[0] ?? 0;
    const share = Math.min(Math.max((value - least) / (most - least), 0), 1);
    return { label: text(label, name), look, value, share };
  });
}

/** What a robot shows; null for one without a display, which is drawn as what drives. */
export function faceOf(robot: Robot | undefined, shown: Readonly<Record<string, readonly number[]>>): Face | null {
  if (robot === undefined) return null;
  const { display, music, pins } = partsOf(robot);
  if (display === undefined) return null;
  return {
    rows: shown[display.name] ?? DARK,
    sounds: music.some(({ name }) => (shown[name] ?? []).some((number) => number > 0)),
    pins: pins.map(({ name }) => {
      const [use = 0, value = 0] = shown[name] ?? [];
      return Math.min(1, Math.max(0, value / (MOST[use] ?? 1)));
    }),
  };
}

/** The lights of a row, from the left. */
export function lightsOf(row: number): number[] {
  return Array.from({ length: 5 }, (_, x) => Math.floor(row / 10 ** (4 - x)) % 10);
}
